; MRGV: C := the next A where Z has ones, the next B where it has zeros

        .include "vector.inc"

        .data
a:      .word   1.0, 2.0, X'7ABC 0123 4567 89AB', 4.0, 5.0, 6.0
b:      .word   11.0, 12.0, 13.0, 14.0, 15.0, 16.0
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        operands_of_two
        into    plain
        MRGV    [va], [vb], [to] ? [vz]
        into    zeros
        MRGV    [va], [vb], [to] ?! [vz]
        into    broadcast_a
        MRGV    x, [vb], [to] ? [vz]
        into    broadcast_b
        MRGV    [va], y, [to] ? [vz]
        into    offset_sources
        MRGV    [va, once], [vb, twice], [to] ? [vz]
        into    short_sources           ; continued with machine zeros
        ELEN    short_a, 2
        MRGV    [short_a], [short_b], [to] ? [vz]
        into    nothing, 0
        MRGV    [va], [vb], [to] ? [vz]
; expect: [plain] = 1.0, 11.0, 2.0, X'7ABC 0123 4567 89AB', 12.0, 13.0
; expect: [zeros] = 11.0, 1.0, 12.0, 13.0, 2.0, X'7ABC 0123 4567 89AB'
; expect: [broadcast_a] = 8.0, 11.0, 8.0, 8.0, 12.0, 13.0
; expect: [broadcast_b] = 1.0, -0.5, 2.0, X'7ABC 0123 4567 89AB', -0.5, -0.5
; expect: [offset_sources] = 2.0, 13.0, X'7ABC 0123 4567 89AB', 4.0, 14.0, 15.0
; expect: [short_sources] = 1.0, 11.0, 2.0, 0.0, 12.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
