; POLYV: C(i) := value at A(i) of the polynomial with the coefficients B,
; highest first

        .include "vector.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 0.5, -0.5, 10.0
b:      .word   2.0, -3.0, 1.0          ; 2xx - 3x + 1
scalars:
        .word   4.0, 0.0
        .bitvector z, n, "101100"
        .code

        operands
        descriptor vb, b, 3
        into    plain
        POLYV   [va], [vb], [to]
        into    broadcast
        POLYV   x, [vb], [to]
        into    where_ones
        POLYV   [va], [vb], [to] ? [vz]
        into    where_zeros
        POLYV   [va], [vb], [to] ?! [vz]
        into    offset_sources          ; -3x + 1; machine zero follows A
        POLYV   [va, once], [vb, once], [to]
        into    offset_result           ; and of the control vector
        POLYV   [va], [vb], [to, by] ? [vz]
        into    negated
        POLYV   -[va], [vb], [to]
        into    magnitudes
        POLYV   |[va]|, |[vb]|, [to]
        into    nothing, 0
        POLYV   [va], [vb], [to]
; expect: [plain] = 0.0, 15.0, 10.0, 0.0, 3.0, 171.0
; expect: [broadcast] = 21.0, 21.0, 21.0, 21.0, 21.0, 21.0
; expect: [where_ones] = 0.0, 9.0, 10.0, 0.0, 9.0, 9.0
; expect: [where_zeros] = 9.0, 15.0, 9.0, 9.0, 3.0, 171.0
; expect: [offset_sources] = 7.0, -8.0, -0.5, 2.5, -29.0, 1.0
; expect: [offset_result] = 9.0, 9.0, 15.0, 10.0, 9.0, 9.0
; expect: [negated] = 6.0, 3.0, 28.0, 3.0, 0.0, 231.0
; expect: [magnitudes] = 6.0, 15.0, 28.0, 3.0, 3.0, 231.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

; one coefficient as it is, whatever x is; no coefficient
        .data
odd_b:  .word   5
odd_a:  .word   X'7000 0000 0000 0000', 1.0, 1.0, 1.0, 1.0, 1.0
        .code
        descriptor from, odd_a, n
        descriptor vb, odd_b, 1
        into    constant
        POLYV   [from], [vb], [to]
        ELEN    vb, 0
        into    none
        POLYV   [from], [vb], [to]
; expect: [constant] = 5, 5, 5, 5, 5, 5
; expect: [none] = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0

; Each value is the next x.
        .data
chain:  .word   1.0, 9.0, 9.0, 9.0
        .code
        descriptor from, chain, 3
        descriptor vb, b, 3
        descriptor to, chain + 64, 3
        POLYV   [from], [vb], [to]
; expect: [chain] = 1.0, 0.0, 1.0, 0.0

; The first value is a coefficient for the second.
        .data
changed: .word  2.0, -3.0, 1.0
        .code
        descriptor vb, changed, 3
        descriptor to, changed + 64, 2
        POLYV   [va], [vb], [to]
; expect: [changed] = 2.0, 0.0, 9.0

        EXIT
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: zero-length
; expect-warning: recurrence
