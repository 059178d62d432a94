; Results of instructions with one source are compared with words worked out by hand:
; numbers of both signs, integers, the ends of the exponent range, specials, every use
; of a vector.  A wrong rounding, root, exponent, neighbour or flag makes a word differ.
; tests: FLR TRU CLG ABS SQRT EXP FLRH TRUH CLGH ABSH SQRTH EXPH TRUV FLRV CLGV ABSV
; tests: EXPV SQRTV VTOV ADJMV DELTAV VREVV
; warns: recurrence TRUV FLRV CLGV ABSV EXPV SQRTV VTOV ADJMV DELTAV
; warns: zero-length TRUV FLRV CLGV ABSV EXPV SQRTV VTOV ADJMV DELTAV VREVV

        .include "scalar.inc"
        .include "unary.inc"

        pair    plain, 2.75
        pair    negative, -2.75
        pair    whole, -3.0
        pair    small, 0.5
        pair    small_negative, -0.5
        sized_pair tiny_negative, X'F000 8000 0000 0000', 0, X'9080 0000', 0
; numbers with an exponent of 0 or more are unchanged
        pair    integer, -7
        sized_pair large, X'0005 4000 0000 0000', 0, X'0540 0000', 0
; 2.5
        sized_pair unnormalised, X'FFFF 0000 0000 0005', 0, X'FF00 0005', 0
; specials are unchanged
        pair    zero, 0.0
        sized_pair indefinite, X'7000 0000 0000 0000', 0, X'7000 0000', 0
; FLR, TRU and CLG of the numbers that are small integers in both sizes
        .macro  rounded name, f, t, c
        makes_both FLR, \name, \f, \f
        makes_both TRU, \name, \t, \t
        makes_both CLG, \name, \c, \c
        .endm

        rounded plain, 2, 2, 3
        rounded negative, -3, -2, -2
        rounded whole, -3, -3, -3
        rounded small, 0, 0, 1
        rounded small_negative, -1, 0, 0
        rounded integer, -7, -7, -7
        rounded unnormalised, 2, 2, 3
; FLR: T := greatest integer not above R, with exponent 0
        makes_both FLR, tiny_negative, -1, -1
        makes_both FLR, large, X'0005 4000 0000 0000', X'0540 0000'
        makes_both FLR, zero, 0.0, 0.0
        makes_both FLR, indefinite, indefinite, X'7000 0000'
        of_zero FLR
        both_flags FLR, X'0000 0000 0012 0000'
; TRU: T := R truncated to an integer with exponent 0
        makes_both TRU, tiny_negative, 0, 0
        makes_both TRU, large, X'0005 4000 0000 0000', X'0540 0000'
        makes_both TRU, zero, 0.0, 0.0
        makes_both TRU, indefinite, indefinite, X'7000 0000'
        of_zero TRU
        both_flags TRU, X'0000 0000 0012 0000'
; CLG: T := least integer not below R, with exponent 0
        sized_one CLG, tiny, X'F000 4000 0000 0000', 1, X'9040 0000', 1
        one     CLG, least, X'FFFF 8000 0000 0000', X'0000 C000 0000 0000'
        one_half CLGH, least, X'FF80 0000', X'00C0 0000'
        makes_both CLG, large, X'0005 4000 0000 0000', X'0540 0000'
; specials are unchanged
        one     CLG, zero, X'8123 0000 0000 0005', X'8123 0000 0000 0005'
        one_half CLGH, zero, X'8000 0005', X'8000 0005'
        makes_both CLG, indefinite, indefinite, X'7000 0000'
        of_zero CLG
        both_flags CLG, X'0000 0000 0012 0000'
; ABS: T := |R|
        both_one ABS, positive, 2.5, 2.5, 2.5
        both_one ABS, negative, -2.5, 2.5, 2.5
        makes_both ABS, integer, 7, 7
; 2^47 does not fit: the exponent is increased by 1
        one     ABS, least, X'0000 8000 0000 0000', X'0001 4000 0000 0000'
        one_half ABSH, least, X'0080 0000', X'0140 0000'
        makes_both ABS, zero, 0.0, 0.0
        makes_both ABS, indefinite, indefinite, X'7000 0000'
; exponent overflow
        one     ABS, overflow, X'6FFF 8000 0000 0000', indefinite
        one_half ABSH, overflow, X'6F80 0000', X'7000 0000'
        of_zero ABS
        both_flags ABS, X'0000 0000 0032 0000'
; SQRT: T := square root of R
        both_one SQRT, four, 4.0, 2.0, 2.0
; rounded down (floor)
        both_one SQRT, inexact, 2.0, X'FFD2 5A82 7999 FCEF', X'EA5A 8279'
        both_one SQRT, quarter, 0.0625, 0.25, 0.25
; as many significant bits as the operand: 16 has 5 bits
        both_one SQRT, integer, 16, X'FFFE 0000 0000 0010', X'FE00 0010'
; 18 with 4 significant bits
        one     SQRT, unnormalised, X'0001 0000 0000 0009', X'FFFF 0000 0000 0008'
        one_half SQRTH, unnormalised, X'0100 0009', X'FF00 0008'
        one     SQRT, large, X'6FFF 7FFF FFFF FFFF', X'37E8 7FFF FFFF FFFF'
        one_half SQRTH, large, X'6F7F FFFF', X'2C7F FFFF'
        one     SQRT, small, X'9000 4000 0000 0000', X'C7E9 4000 0000 0000'
        one_half SQRTH, small, X'9040 0000', X'BD40 0000'
        makes_both SQRT, zero, 0.0, 0.0
        sized_one SQRT, zero_coefficient, X'0010 0000 0000 0000', 0.0, X'1000 0000', 0.0
; imaginary root
        both_one SQRT, imaginary, -1.0, indefinite, X'7000 0000'
        makes_both SQRT, indefinite, indefinite, X'7000 0000'
        of_zero SQRT
        both_flags SQRT, X'0000 0000 0016 0000'
; EXP: T := exponent of R, as an integer
        both_one EXP, plain, 1.0, -46, -22
        sized_one EXP, large, X'6FFF 7FFF FFFF FFFF', 28671, X'6F7F FFFF', 111
        sized_one EXP, small, X'9000 4000 0000 0000', -28672, X'9040 0000', -112
        both_one EXP, integer, 5, 0, 0
        makes_both EXP, zero, -32768, -128
        makes_both EXP, indefinite, 28672, 112
        both_flags EXP, X'0000 0000 0000 0000'

; ---- Vectors ----
        .data
a:      .word   2.25, -2.25, 16.0, -0.5, 100.0, 0.75
scalars:
        .word   8.0, 0.0
root_a: .word   4.0, 2.0, 0.0625, -1.0, 100.0, 6.25
root_scalars:
        .word   8.0, 0.0
        .code
; TRUV: C := A truncated to integers with exponent 0
        elements TRUV, 2, -2, 16, 0, 100, 0
        all_uses TRUV, 8, 0.0
; expect: [TRUV.chain] = 2.25, 2, 2, 2, 2, 2, 2
; expect: [TRUV.negated] = -2, 2, -16, 0, -100, 0
; expect: [TRUV.magnitudes] = 2, 2, 16, 0, 100, 0
; expect: [TRUV.negative] = -2, -2, -16, 0, -100, 0
        first_specials TRUV, 5, -7, X'FFFF 0000 0000 0005'
        last_specials TRUV, 0.0, indefinite, X'6FFF 7FFF FFFF FFFF'
; expect: [TRUV.odd] = 5, -7, 2, 0.0, indefinite, X'6FFF 7FFF FFFF FFFF'
        flags_are TRUV, X'0000 0000 0012 0000'
; FLRV: C := greatest integers not above A, with exponent 0
        elements FLRV, 2, -3, 16, -1, 100, 0
        all_uses FLRV, 8, 0.0
; expect: [FLRV.chain] = 2.25, 2, 2, 2, 2, 2, 2
; expect: [FLRV.negated] = -3, 2, -16, 0, -100, -1
; expect: [FLRV.magnitudes] = 2, 2, 16, 0, 100, 0
; expect: [FLRV.negative] = -3, -3, -16, -1, -100, -1
        first_specials FLRV, 5, -7, X'FFFF 0000 0000 0005'
        last_specials FLRV, 0.0, indefinite, X'6FFF 7FFF FFFF FFFF'
; expect: [FLRV.odd] = 5, -7, 2, 0.0, indefinite, X'6FFF 7FFF FFFF FFFF'
        flags_are FLRV, X'0000 0000 0012 0000'
; CLGV: C := least integers not below A, with exponent 0
        elements CLGV, 3, -2, 16, 0, 100, 1
        all_uses CLGV, 8, 0.0
; expect: [CLGV.chain] = 2.25, 3, 3, 3, 3, 3, 3
; expect: [CLGV.negated] = -2, 3, -16, 1, -100, 0
; expect: [CLGV.magnitudes] = 3, 3, 16, 1, 100, 1
; expect: [CLGV.negative] = -2, -2, -16, 0, -100, 0
        first_specials CLGV, 5, -7, X'FFFF 0000 0000 0005'
        last_specials CLGV, 0.0, indefinite, X'6FFF 7FFF FFFF FFFF'
; expect: [CLGV.odd] = 5, -7, 3, 0.0, indefinite, X'6FFF 7FFF FFFF FFFF'
        flags_are CLGV, X'0000 0000 0012 0000'
; ABSV: C := |A|
        elements ABSV, 2.25, 2.25, 16.0, 0.5, 100.0, 0.75
        all_uses ABSV, 8.0, 0.0
; expect: [ABSV.chain] = 2.25, 2.25, 2.25, 2.25, 2.25, 2.25, 2.25
; expect: [ABSV.negated] = 2.25, 2.25, 16.0, 0.5, 100.0, 0.75
; expect: [ABSV.magnitudes] = 2.25, 2.25, 16.0, 0.5, 100.0, 0.75
; expect: [ABSV.negative] = 2.25, 2.25, 16.0, 0.5, 100.0, 0.75
        first_specials ABSV, 5, -7, X'0000 8000 0000 0000'
        last_specials ABSV, 0.0, indefinite, X'6FFF 8000 0000 0000'
; expect: [ABSV.odd] = 5, 7, X'0001 4000 0000 0000', 0.0, indefinite, indefinite
        flags_are ABSV, X'0000 0000 0032 0000'
; EXPV: C := exponent of A, as an integer
        elements EXPV, -45, -45, -42, -48, -40, -47
        all_uses EXPV, -43, -32768
; expect: [EXPV.chain] = 2.25, -45, 0, 0, 0, 0, 0
; expect: [EXPV.negated] = -45, -45, -43, -47, -40, -47
; expect: [EXPV.magnitudes] = -45, -45, -42, -47, -40, -47
; expect: [EXPV.negative] = -45, -45, -43, -48, -40, -47
        first_specials EXPV, 5, X'6FFF 7FFF FFFF FFFF', X'9000 4000 0000 0000'
        last_specials EXPV, 0.0, indefinite, X'FFFF 0000 0000 0005'
; expect: [EXPV.odd] = 0, 28671, -28672, -32768, 28672, -1
        flags_are EXPV, X'0000 0000 0000 0000'
; SQRTV: C := square root of A
        elements SQRTV, 2.0, X'FFD25A827999FCEF', 0.25, indefinite, 10.0, 2.5
        all_uses SQRTV, X'FFD3 5A82 7999 FCEF', 0.0, root_
; expect: [SQRTV.chain] = 2.25, 1.5, X'FFD2 4E62 3850 2484', X'FFD2 46D3 E067 0BFD'
; expect: [SQRTV.chain + 4*64] = X'FFD2 4353 CBCA 7944', X'FFD2 41A4 8079 9D94'
; expect: [SQRTV.chain + 6*64] = X'FFD2 40D0 EB3E 9314'
; expect: [SQRTV.negated] = indefinite, indefinite, indefinite, 1.0, indefinite
; expect: [SQRTV.negated + 5*64] = indefinite
; expect: [SQRTV.magnitudes] = 2.0, X'FFD2 5A82 7999 FCEF', 0.25, 1.0, 10.0, 2.5
; expect: [SQRTV.negative] = indefinite, indefinite, indefinite, indefinite, indefinite
; expect: [SQRTV.negative + 5*64] = indefinite
        first_specials SQRTV, 16, X'0001 0000 0000 0009', 0.0
        last_specials SQRTV, X'0010000000000000', indefinite, X'6FFF7FFFFFFFFFFF'
; expect: [SQRTV.odd] = X'FFFE 0000 0000 0010', X'FFFF 0000 0000 0008', 0.0, 0.0
; expect: [SQRTV.odd + 4*64] = indefinite, X'37E8 7FFF FFFF FFFF'
        flags_are SQRTV, X'0000 0000 0016 0000'
; VTOV: C := A
        elements VTOV, 2.25, -2.25, 16.0, -0.5, 100.0, 0.75
        all_uses VTOV, 8.0, 0.0
; expect: [VTOV.chain] = 2.25, 2.25, 2.25, 2.25, 2.25, 2.25, 2.25
; expect: [VTOV.negated] = -2.25, 2.25, -16.0, 0.5, -100.0, -0.75
; expect: [VTOV.magnitudes] = 2.25, 2.25, 16.0, 0.5, 100.0, 0.75
; expect: [VTOV.negative] = -2.25, -2.25, -16.0, -0.5, -100.0, -0.75
        first_specials VTOV, 5, X'8FFF 1234 5678 9ABC', X'7ABC 0000 0000 0001'
        last_specials VTOV, 0, X'0000 8000 0000 0000', X'6FFF 7FFF FFFF FFFF'
; expect: [VTOV.odd] = 5, X'8FFF 1234 5678 9ABC', X'7ABC 0000 0000 0001', 0
; expect: [VTOV.odd + 4*64] = X'0000 8000 0000 0000', X'6FFF 7FFF FFFF FFFF'
        flags_are VTOV, X'0000 0000 0000 0000'
; ADJMV: C(i) := normalised(A(i+1) + A(i)) / 2
        elements ADJMV, 0.0, 6.875, 7.75, 49.75, 50.375, 0.375
        uses    ADJMV, 8.0
; expect: [ADJMV.offset_source] = 7.75, 49.75, 50.375, 0.375, 0.0, 0.0
; expect: [ADJMV.offset_result] = 9.0, 9.0, 6.875, 7.75, 9.0, 9.0
; expect: [ADJMV.short_source] = 0.0, 6.875, 7.75, -0.25, 0.0, 0.0
        overlap ADJMV
; expect: [ADJMV.chain] = 2.25, 9.125, 6.3125, -0.84375, 2.078125, 1.5390625, 0.76953125
        signs   ADJMV
; expect: [ADJMV.negated] = 0.0, -6.875, -7.75, -49.75, -50.375, -0.375
; expect: [ADJMV.magnitudes] = 2.25, 9.125, 8.25, 50.25, 50.375, 0.375
; expect: [ADJMV.negative] = -2.25, -9.125, -8.25, -50.25, -50.375, -0.375
        specials ADJMV, 5, 3, indefinite, 1.0, 0.0, 2.0
; expect: [ADJMV.odd] = 4.0, indefinite, indefinite, 0.5, 1.0, 1.0
        flags_are ADJMV, X'0000 0000 0012 0000'
; DELTAV: C(i) := normalised(A(i+1) - A(i))
        elements DELTAV, -4.5, 18.25, -16.5, 100.5, -99.25, -0.75
        uses    DELTAV, 0.0
; expect: [DELTAV.offset_source] = -16.5, 100.5, -99.25, -0.75, 0.0, 0.0
; expect: [DELTAV.offset_result] = 9.0, 9.0, 18.25, -16.5, 9.0, 9.0
; expect: [DELTAV.short_source] = -4.5, 18.25, -16.5, 0.5, 0.0, 0.0
        overlap DELTAV
; expect: [DELTAV.chain] = 2.25, 13.75, -10.25, 2.25, 2.75, -1.75, 1.75
        signs   DELTAV
; expect: [DELTAV.negated] = 4.5, -18.25, 16.5, -100.5, 99.25, 0.75
; expect: [DELTAV.magnitudes] = 0.0, 13.75, -15.5, 99.5, -99.25, -0.75
; expect: [DELTAV.negative] = 0.0, -13.75, 15.5, -99.5, 99.25, 0.75
        specials DELTAV, 5, 8, 8, 0.0, indefinite, X'6FFF 7FFF FFFF FFFF'
; expect: [DELTAV.odd] = 3.0, 0.0, -8.0, indefinite, indefinite, X'6FFF 8000 0000 0001'
        flags_are DELTAV, X'0000 0000 0012 0000'
; VREVV: C := A, last element first: C(i) := A(n - 1 - i), n the length of C
        elements VREVV, 0.75, 100.0, -0.5, 16.0, -2.25, 2.25
        uses    VREVV, 8.0
; expect: [VREVV.offset_source] = 0.0, 0.0, 0.75, 100.0, -0.5, 16.0
; expect: [VREVV.offset_result] = 9.0, 9.0, -0.5, 16.0, 9.0, 9.0
; expect: [VREVV.short_source] = 0.0, 0.0, -0.5, 16.0, -2.25, 2.25
        overlap VREVV
; expect: [VREVV.chain] = 2.25, 1.0, 5.0, -8.0, 5.0, 1.0, 2.25
        flags_are VREVV, X'0000 0000 0000 0000'
        EXIT
; expect-warning: recurrence
