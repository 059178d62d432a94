; Arithmetic series and values of polynomials are compared with words worked out by
; hand, for every use, and for results that are read again.  A wrong order of additions,
; coefficient, truncation or data flag makes a word differ.
; tests: INTVLV POLYV
; warns: recurrence POLYV
; warns: zero-length INTVLV POLYV

        .include "vector.inc"

; INTVLV: C := A, A+B, A+2B, ... by repeated upper addition
        .data
INTVLV.a:
INTVLV.scalars:
        .word   1.0, 0.5
INTVLV.integers:
        .word   7, -2
INTVLV.large: .word   X'6FFF 7FFF FFFF FFFF'
        .code
        operands INTVLV.
        of_two  INTVLV, plain, x, y, [to]
        of_two  INTVLV, where_ones, x, y, [to] ? [vz] ; the sums continue where none is stored
        of_two  INTVLV, where_zeros, x, y, [to] ?! [vz]
        of_two  INTVLV, offset_result, x, y, [to, by] ? [vz] ; starts at element 1
        of_two  INTVLV, negated, -x, |y|, [to]
        into    INTVLV.nothing, 0
        INTVLV  x, y, [to]
        of_two  INTVLV, constant, x, r0, [to] ; r0 is machine zero
; expect: [INTVLV.plain] = 1.0, 1.5, 2.0, 2.5, 3.0, 3.5
; expect: [INTVLV.where_ones] = 1.0, 9.0, 2.0, 2.5, 9.0, 9.0
; expect: [INTVLV.where_zeros] = 9.0, 1.5, 9.0, 9.0, 3.0, 3.5
; expect: [INTVLV.offset_result] = 9.0, 9.0, 1.5, 2.0, 9.0, 9.0
; expect: [INTVLV.constant] = 1.0, 1.0, 1.0, 1.0, 1.0, 1.0
; expect: [INTVLV.nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; The sums are upper results: the exponent is the larger one, and the coefficient may be
; unnormalised.  -1.0 is FFD1 8000 .., plus 0.5 (FFD1 4000 ..) gives
; FFD1 C000 .., and so on.
; expect: [INTVLV.negated] = -1.0, X'FFD1 C000 0000 0000', zero.47, 0.5, 1.0, 1.5
        load    x, INTVLV.integers
        load    y, INTVLV.integers + 64
        of_two  INTVLV, countdown, x, y, [to]
; expect: [INTVLV.countdown] = 7, 5, 3, 1, X'0000FFFFFFFFFFFF', X'0000FFFFFFFFFFFD'
; exponent overflow in the second element; indefinite from there on
        load    x, INTVLV.large
        into    INTVLV.overflow, 2
        INTVLV  x, x, [to]
; expect: [INTVLV.overflow] = X'6FFF 7FFF FFFF FFFF', indefinite, 9.0
        flags_are INTVLV, X'0000 0000 0022 0000'
; POLYV: C(i) := value at A(i) of the polynomial with coefficients B, highest first
        .data
POLYV.a: .word   1.0, -2.0, 3.0, 0.5, -0.5, 10.0
POLYV.b: .word   2.0, -3.0, 1.0          ; 2xx - 3x + 1
POLYV.scalars:
        .word   4.0, 0.0
POLYV.odd_b: .word   5
POLYV.odd_a: .word   X'7000 0000 0000 0000', 1.0, 1.0, 1.0, 1.0, 1.0
POLYV.chain: .word   1.0, 9.0, 9.0, 9.0
POLYV.changed: .word  2.0, -3.0, 1.0
        .code
        operands POLYV.
        descriptor vb, POLYV.b, 3
        of_two  POLYV, plain, [va], [vb], [to]
        of_two  POLYV, broadcast, x, [vb], [to]
        of_two  POLYV, where_ones, [va], [vb], [to] ? [vz]
        of_two  POLYV, where_zeros, [va], [vb], [to] ?! [vz]
        of_two  POLYV, offset_sources, [va, once], [vb, once], [to] ; -3x + 1; machine zero follows A
        of_two  POLYV, offset_result, [va], [vb], [to, by] ? [vz] ; also offsets the control vector
        of_two  POLYV, negated, -[va], [vb], [to]
        of_two  POLYV, magnitudes, |[va]|, |[vb]|, [to]
        into    POLYV.nothing, 0
        POLYV   [va], [vb], [to]
; expect: [POLYV.plain] = 0.0, 15.0, 10.0, 0.0, 3.0, 171.0
; expect: [POLYV.broadcast] = 21.0, 21.0, 21.0, 21.0, 21.0, 21.0
; expect: [POLYV.where_ones] = 0.0, 9.0, 10.0, 0.0, 9.0, 9.0
; expect: [POLYV.where_zeros] = 9.0, 15.0, 9.0, 9.0, 3.0, 171.0
; expect: [POLYV.offset_sources] = 7.0, -8.0, -0.5, 2.5, -29.0, 1.0
; expect: [POLYV.offset_result] = 9.0, 9.0, 15.0, 10.0, 9.0, 9.0
; expect: [POLYV.negated] = 6.0, 3.0, 28.0, 3.0, 0.0, 231.0
; expect: [POLYV.magnitudes] = 6.0, 15.0, 28.0, 3.0, 3.0, 231.0
; expect: [POLYV.nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; one coefficient is returned unchanged for every x; then no coefficient
        descriptor from, POLYV.odd_a, n
        descriptor vb, POLYV.odd_b, 1
        of_two  POLYV, constant, [from], [vb], [to]
        ELEN    vb, 0
        of_two  POLYV, none, [from], [vb], [to]
; expect: [POLYV.constant] = 5, 5, 5, 5, 5, 5
; expect: [POLYV.none] = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
; Each value is the x of the next element.
        descriptor from, POLYV.chain, 3
        descriptor vb, POLYV.b, 3
        descriptor to, POLYV.chain + 64, 3
        POLYV   [from], [vb], [to]
; expect: [POLYV.chain] = 1.0, 0.0, 1.0, 0.0
; The first value replaces a coefficient for the second.
        descriptor vb, POLYV.changed, 3
        descriptor to, POLYV.changed + 64, 2
        POLYV   [va], [vb], [to]
; expect: [POLYV.changed] = 2.0, 0.0, 9.0
        flags_are POLYV, X'0000 0000 0010 0000'
        EXIT
; expect-warning: zero-length
; expect-warning: recurrence
