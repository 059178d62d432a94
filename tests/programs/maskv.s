; MASKV: C := A where Z has ones, B where it has zeros

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
        MASKV   [va], [vb], [to] ? [vz]
        into    zeros
        MASKV   [va], [vb], [to] ?! [vz]
        into    broadcast_a
        MASKV   x, [vb], [to] ? [vz]
        into    broadcast_b
        MASKV   [va], y, [to] ? [vz]
        into    offset_sources
        MASKV   [va, once], [vb, twice], [to] ? [vz]
        into    offset_result           ; and of the control vector
        MASKV   [va], [vb], [to, by] ? [vz]
        into    short_sources           ; continued with machine zeros
        MASKV   [short_a], [short_b], [to] ? [vz]
        into    nothing, 0
        MASKV   [va], [vb], [to] ? [vz]
; expect: [plain] = 1.0, 12.0, X'7ABC 0123 4567 89AB', 4.0, 15.0, 16.0
; expect: [zeros] = 11.0, 2.0, 13.0, 14.0, 5.0, 6.0
; expect: [broadcast_a] = 8.0, 12.0, 8.0, 8.0, 15.0, 16.0
; expect: [broadcast_b] = 1.0, -0.5, X'7ABC 0123 4567 89AB', 4.0, -0.5, -0.5
; expect: [offset_sources] = 2.0, 14.0, 4.0, 5.0, 0.0, 0.0
; expect: [offset_result] = 9.0, 11.0, 2.0, X'7ABC 0123 4567 89AB', 14.0, 15.0
; expect: [short_sources] = 1.0, 12.0, X'7ABC 0123 4567 89AB', 4.0, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

; The result lies one word after A: each element is taken from the one before.
        .data
chain:  .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0
        .code
        descriptor from, chain, n
        descriptor to, chain + 64, n
        MASKV   [from], [vb], [to] ? [vz]
; expect: [chain] = 1.0, 1.0, 12.0, 12.0, 12.0, 15.0, 16.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
