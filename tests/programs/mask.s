; Vectors that a control vector selects from two sources are compared with words worked
; out by hand, for every use.  A wrong source or element makes a word differ.
; tests: MASKV MRGV
; warns: zero-length MASKV MRGV

        .include "vector.inc"

; MASKV: C := A where Z has ones, B where Z has zeros
        .data
MASKV.a: .word   1.0, 2.0, X'7ABC 0123 4567 89AB', 4.0, 5.0, 6.0
MASKV.b: .word   11.0, 12.0, 13.0, 14.0, 15.0, 16.0
MASKV.scalars:
        .word   8.0, -0.5
MASKV.chain: .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0
        .code
        operands_of_two MASKV.
        of_two  MASKV, plain, [va], [vb], [to] ? [vz]
        of_two  MASKV, zeros, [va], [vb], [to] ?! [vz]
        of_two  MASKV, broadcast_a, x, [vb], [to] ? [vz]
        of_two  MASKV, broadcast_b, [va], y, [to] ? [vz]
        of_two  MASKV, offset_sources, [va, once], [vb, twice], [to] ? [vz]
        of_two  MASKV, offset_result, [va], [vb], [to, by] ? [vz] ; also offsets the control vector
        of_two  MASKV, short_sources, [short_a], [short_b], [to] ? [vz] ; padded with machine zeros
        into    MASKV.nothing, 0
        MASKV   [va], [vb], [to] ? [vz]
; expect: [MASKV.plain] = 1.0, 12.0, X'7ABC 0123 4567 89AB', 4.0, 15.0, 16.0
; expect: [MASKV.zeros] = 11.0, 2.0, 13.0, 14.0, 5.0, 6.0
; expect: [MASKV.broadcast_a] = 8.0, 12.0, 8.0, 8.0, 15.0, 16.0
; expect: [MASKV.broadcast_b] = 1.0, -0.5, X'7ABC 0123 4567 89AB', 4.0, -0.5, -0.5
; expect: [MASKV.offset_sources] = 2.0, 14.0, 4.0, 5.0, 0.0, 0.0
; expect: [MASKV.offset_result] = 9.0, 11.0, 2.0, X'7ABC 0123 4567 89AB', 14.0, 15.0
; expect: [MASKV.short_sources] = 1.0, 12.0, X'7ABC 0123 4567 89AB', 4.0, 0.0, 0.0
; expect: [MASKV.nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; The result starts one word after A, so each element comes from the one before it.
        descriptor from, MASKV.chain, n
        descriptor to, MASKV.chain + 64, n
        MASKV   [from], [vb], [to] ? [vz]
; expect: [MASKV.chain] = 1.0, 1.0, 12.0, 12.0, 12.0, 15.0, 16.0
        flags_are MASKV, X'0000 0000 0000 0000'
; MRGV: C := the next element of A where Z has a one, the next element of B
; where Z has a zero
        .data
MRGV.a: .word   1.0, 2.0, X'7ABC 0123 4567 89AB', 4.0, 5.0, 6.0
MRGV.b: .word   11.0, 12.0, 13.0, 14.0, 15.0, 16.0
MRGV.scalars:
        .word   8.0, -0.5
        .code
        operands_of_two MRGV.
        of_two  MRGV, plain, [va], [vb], [to] ? [vz]
        of_two  MRGV, zeros, [va], [vb], [to] ?! [vz]
        of_two  MRGV, broadcast_a, x, [vb], [to] ? [vz]
        of_two  MRGV, broadcast_b, [va], y, [to] ? [vz]
        of_two  MRGV, offset_sources, [va, once], [vb, twice], [to] ? [vz]
        into    MRGV.short_sources           ; padded with machine zeros
        ELEN    short_a, 2
        MRGV    [short_a], [short_b], [to] ? [vz]
        into    MRGV.nothing, 0
        MRGV    [va], [vb], [to] ? [vz]
; expect: [MRGV.plain] = 1.0, 11.0, 2.0, X'7ABC 0123 4567 89AB', 12.0, 13.0
; expect: [MRGV.zeros] = 11.0, 1.0, 12.0, 13.0, 2.0, X'7ABC 0123 4567 89AB'
; expect: [MRGV.broadcast_a] = 8.0, 11.0, 8.0, 8.0, 12.0, 13.0
; expect: [MRGV.broadcast_b] = 1.0, -0.5, 2.0, X'7ABC 0123 4567 89AB', -0.5, -0.5
; expect: [MRGV.offset_sources] = 2.0, 13.0, X'7ABC 0123 4567 89AB', 4.0, 14.0, 15.0
; expect: [MRGV.short_sources] = 1.0, 11.0, 2.0, 0.0, 12.0, 0.0
; expect: [MRGV.nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
        flags_are MRGV, X'0000 0000 0000 0000'
        EXIT
; expect-warning: zero-length
