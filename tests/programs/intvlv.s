; INTVLV: C := A, A+B, A+2B, ... by repeated upper addition

        .include "vector.inc"

        .data
a:
scalars:
        .word   1.0, 0.5
        .bitvector z, n, "101100"
integers:
        .word   7, -2
large:  .word   X'6FFF 7FFF FFFF FFFF'
        .code

        operands
        into    plain
        INTVLV  x, y, [to]
        into    where_ones              ; the sums go on where none is stored
        INTVLV  x, y, [to] ? [vz]
        into    where_zeros
        INTVLV  x, y, [to] ?! [vz]
        into    offset_result           ; one element less, from the second on
        INTVLV  x, y, [to, by] ? [vz]
        into    negated
        INTVLV  -x, |y|, [to]
        into    nothing, 0
        INTVLV  x, y, [to]
        into    constant
        INTVLV  x, r0, [to]             ; r0 is machine zero
; expect: [plain] = 1.0, 1.5, 2.0, 2.5, 3.0, 3.5
; expect: [where_ones] = 1.0, 9.0, 2.0, 2.5, 9.0, 9.0
; expect: [where_zeros] = 9.0, 1.5, 9.0, 9.0, 3.0, 3.5
; expect: [offset_result] = 9.0, 9.0, 1.5, 2.0, 9.0, 9.0
; expect: [constant] = 1.0, 1.0, 1.0, 1.0, 1.0, 1.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

; The sums are upper ones: the exponent is the larger and the coefficient need
; not be normalised.  -1.0 is FFD1 8000 .., plus 0.5 (FFD1 4000 ..) gives
; FFD1 C000 .., and so on.
; expect: [negated] = -1.0, X'FFD1 C000 0000 0000', X'FFD1 0000 0000 0000'
; expect: [negated + 3*64] = 0.5, 1.0, 1.5

        load    x, integers
        load    y, integers + 64
        into    countdown
        INTVLV  x, y, [to]
; expect: [countdown] = 7, 5, 3, 1, X'0000 FFFF FFFF FFFF'
; expect: [countdown + 5*64] = X'0000 FFFF FFFF FFFD'

; exponent overflow in the second element; indefinite from there on
        load    x, large
        into    overflow, 2
        INTVLV  x, x, [to]
; expect: [overflow] = X'6FFF 7FFF FFFF FFFF', X'7000 0000 0000 0000', 9.0

        EXIT
; expect-flags: X'0000 0000 0022 0000'
; expect-warning: zero-length
