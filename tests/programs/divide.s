; The quotients of the pairs in the table, and of vectors, are compared with words
; worked out from the rules of docs/arithmetic.md.  A wrong coefficient, number of
; significant bits, divide fault, sign, length or data flag fails.
; tests: DIVS DIVU DIVSH DIVUH DIVSV DIVUV
; warns: integer-operand DIVS DIVSH
; warns: recurrence DIVSV DIVUV
; warns: zero-length DIVSV DIVUV

        .include "scalar.inc"
        .include "binary.inc"

        pair    plain, 3.0, 2.0
        pair    mixed, -0.5, 10.0
; unnormalised: integers
        pair    integers, 42, 6
; inexact: rounded towards zero
        pair    third, 1.0, 3.0
        pair    minus_third, -1.0, 3.0
; as many significant bits as the less significant operand
        pair    less_significant, 0.1, 5
        sized_pair small, 1, X'0000 7FFF FFFF FFFF', 1, X'007F FFFF'
        pair    zero_dividend, 0.0, 7
        sized_pair no_coefficient, X'0010 0000 0000 0000', 2.0, X'1000 0000', 2.0
; divide fault
        pair    by_zero, 1.0, 0.0
        sized_pair by_zero_coefficient, 1.0, X'0010 0000 0000 0000', 1.0, X'1000 0000'
        pair    zero_by_zero, 0.0, 0.0
        sized_pair indefinite, X'7000 0000 0000 0000', 1.0, X'7000 0000', 1.0
; at the ends of the exponent range
        sized_pair overflow, X'6FFF 7FFF FFFF FFFF', 0.125, X'6F7F FFFF', 0.125
        sized_pair underflow, X'9000 4000 0000 0000', 4.0, X'9040 0000', 4.0
        .macro  quotients name, s, u
        gives   DIVS, \name, \s
        gives   DIVU, \name, \u
        .endm

        .macro  half_quotients name, s, u
        gives_half DIVSH, \name, \s
        gives_half DIVUH, \name, \u
        .endm

; DIVS: T := significant(R / S)
; DIVU: T := upper(R / S)
; name, DIVS, DIVU
        quotients plain, 1.5, 1.5
        quotients mixed, X'FFCD 9999 9999 999A', X'FFCD 9999 9999 999A'
        quotients integers, 7, 7.0
        quotients third, X'FFD0 5555 5555 5555', X'FFD0 5555 5555 5555'
        quotients minus_third, X'FFD0 AAAA AAAA AAAB', X'FFD0 AAAA AAAA AAAB'
        quotients less_significant, X'FFF8 0000 0000 0005', X'FFCC 51EB 851E B851'
        quotients small, X'FFD1 0000 0000 0001', X'FFD1 0000 0000 0001'
        quotients zero_dividend, 0.0, 0.0
        quotients no_coefficient, 0.0, X'000E 0000 0000 0000'
        quotients by_zero, indefinite, indefinite
        quotients by_zero_coefficient, indefinite, indefinite
        quotients zero_by_zero, indefinite, indefinite
        quotients indefinite, indefinite, indefinite
        quotients overflow, indefinite, indefinite
        quotients underflow, 0.0, 0.0
; name, DIVSH, DIVUH
        half_quotients plain, 1.5, 1.5
        half_quotients mixed, X'E599 999A', X'E599 999A'
        half_quotients integers, 7, 7.0
        half_quotients third, X'E855 5555', X'E855 5555'
        half_quotients minus_third, X'E8AA AAAB', X'E8AA AAAB'
        half_quotients less_significant, X'F800 0005', X'E451 EB84'
        half_quotients small, X'E900 0001', X'E900 0001'
        half_quotients zero_dividend, 0.0, 0.0
        half_quotients no_coefficient, 0.0, X'0E00 0000'
        half_quotients by_zero, X'7000 0000', X'7000 0000'
        half_quotients by_zero_coefficient, X'7000 0000', X'7000 0000'
        half_quotients zero_by_zero, X'7000 0000', X'7000 0000'
        half_quotients indefinite, X'7000 0000', X'7000 0000'
        half_quotients overflow, X'7000 0000', X'7000 0000'
        half_quotients underflow, 0.0, 0.0
        zeros_and_flags DIVS, 0.0, indefinite, 0.0, X'7000 0000', X'0000 0000 0072 0000'
        zeros_and_flags DIVU, 0.0, indefinite, 0.0, X'7000 0000', X'0000 0000 0072 0000'

; ---- Vectors ----
        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
odd_a:  .word   42, 0.0, 1.0, 1.0, X'6FFF 7FFF FFFF FFFF'
        .word   X'9000 4000 0000 0000'
odd_b:  .word   6, 7, X'7000 0000 0000 0000', 0.0, 0.125, 4.0
        .code
; The quotients of normalised numbers.
        .macro  same_quotients op
; expect: [\op\().offset_sources] = X'FFD1 5555 5555 5555', X'FFD1 5555 5555 5555', 2.25
; expect: [\op\().offset_sources + 3*64] = 2.0, 100.0, 1.0
; expect: [\op\().short_sources + 2*64] = 3.0, 4.5, 1.0, 1.0
; expect: [\op\().chain] = 1.0, X'FFCE 6666 6666 6666', X'FFCF 6666 6666 6666'
; expect: [\op\().chain + 3*64] = X'FFCE BBBB BBBB BBBC', X'FFCB 86A3 14DB F86B'
; expect: [\op\().chain + 5*64] = X'FFCA 86A3 14DB F86B', X'FFCC 795C EB24 0795'
; expect: [\op\().negated] = X'FFCE 9999 9999 999A', 4.0, 1.0, -1.0, 0.25, 400.0
; expect: [\op\().magnitudes] = X'FFCE 6666 6666 6666', 4.0, 1.0, 1.0, 0.25, 400.0
; expect: [\op\().negative] = X'FFCE 9999 9999 999A', -4.0, 1.0, -1.0, -0.25, 400.0
; expect: [\op\().negated_scalar] = X'FFD199999999999A', -16.0, X'FFD3555555555555'
; expect: [\op\().negated_scalar + 3*64] = X'FFD2 8E38 E38E 38E4', -4.0, 32.0
        .endm

; DIVSV: C := significant(A / B)
        elements DIVSV, X'FFCE 6666 6666 6666', -4.0, -1.0, 1.0, -0.25, -400.0
        arithmetic DIVSV, -16.0
; expect: [DIVSV.broadcast_a] = X'FFD1 6666 6666 6666', 16.0, X'FFD3 AAAA AAAA AAAB'
; expect: [DIVSV.broadcast_a + 3*64] = X'FFD2 71C7 1C71 C71C', 4.0, -32.0
; expect: [DIVSV.broadcast_b] = -2.0, 4.0, -6.0, -9.0, 1.0, -200.0
        same_quotients DIVSV
; expect: [DIVSV.odd] = 7, 0.0, indefinite, indefinite, indefinite, 0.0
        flags_are DIVSV, X'0000 0000 0072 0000'
; DIVUV: C := upper(A / B)
        elements DIVUV, X'FFCE 6666 6666 6666', -4.0, -1.0, 1.0, -0.25, -400.0
        arithmetic DIVUV, X'FFD6 C000 0000 0000'
; expect: [DIVUV.broadcast_a] = X'FFD1666666666666', 16.0, X'FFD3AAAAAAAAAAAB'
; expect: [DIVUV.broadcast_a + 3*64] = X'FFD271C71C71C71C', 4.0, X'FFD7C00000000000'
; expect: [DIVUV.broadcast_b] = X'FFD3 C000 0000 0000', 4.0, -6.0, -9.0, 1.0, -200.0
        same_quotients DIVUV
; expect: [DIVUV.odd] = 7.0, 0.0, indefinite, indefinite, indefinite, 0.0
        flags_are DIVUV, X'0000 0000 0072 0000'
        EXIT
; expect-warning: integer-operand
