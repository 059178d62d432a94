; The sums and differences of the pairs in the table, and of vectors, are compared with
; words worked out from the rules of docs/arithmetic.md.  A wrong alignment, rounding,
; special value, sign, length or data flag of one form makes a word differ.
; tests: ADDN ADDU ADDL SUBN SUBU SUBL ADDNH ADDUH ADDLH SUBNH SUBUH SUBLH ADDNV ADDUV
; tests: ADDLV SUBNV SUBUV SUBLV AVGV AVGDV
; warns: recurrence ADDNV ADDUV ADDLV SUBNV SUBUV SUBLV AVGV AVGDV
; warns: zero-length ADDNV ADDUV ADDLV SUBNV SUBUV SUBLV AVGV AVGDV

        .include "scalar.inc"
        .include "binary.inc"

        pair    plain, 1.5, 2.25
        pair    mixed, 10.0, -0.5
        pair    equal, 3.0, 3.0
        pair    opposite, 3.0, -3.0
; unnormalised: integers
        pair    integers, 5, 3
; coefficient overflow
        words   carry, X'0000 7FFF FFFF FFFF', X'0000 7FFF FFFF FFFF'
        halves  carry, X'007F FFFF', X'007F FFFF'
; a tiny negative operand changes the result, because sums are rounded down (floor)
        sized_pair under, 1.0, X'FFA2 8000 0000 0000', 1.0, X'D280 0000'
; shifted out of the register completely
        sized_pair far, 1.0, X'F000 8000 0000 0000', 1.0, X'9080 0000'
; inexact
        pair    tenth, 0.1, 0.2
; the exponent of a zero coefficient takes part in the alignment
        sized_pair zero_coefficient, 1.0, X'0010 0000 0000 0000', 1.0, X'1000 0000'
; machine zero leaves the other operand unchanged
        pair    zero_left, 0.0, 7
        pair    zero_right, -1.5, 0.0
        pair    zero_both, 0.0, 0.0
        sized_pair indefinite, 1.0, X'7000 0000 0000 0000', 1.0, X'7000 0000'
; at the ends of the exponent range
        words   overflow, X'6FFF 7FFF FFFF FFFF', X'6FFF 8000 0000 0000'
        halves  overflow, X'6F7F FFFF', X'6F80 0000'
        words   huge, X'6FFF 7FFF FFFF FFFF', X'6FFF 7FFF FFFF FFFF'
        halves  huge, X'6F7F FFFF', X'6F7F FFFF'
        words   underflow, X'9000 4000 0000 0001', X'9000 4000 0000 0000'
        halves  underflow, X'9040 0001', X'9040 0000'
        .macro  sums name, n, u, l
        gives   ADDN, \name, \n
        gives   ADDU, \name, \u
        gives   ADDL, \name, \l
        .endm

        .macro  differences name, n, u, l
        gives   SUBN, \name, \n
        gives   SUBU, \name, \u
        gives   SUBL, \name, \l
        .endm

        .macro  half_sums name, n, u, l
        gives_half ADDNH, \name, \n
        gives_half ADDUH, \name, \u
        gives_half ADDLH, \name, \l
        .endm

        .macro  half_differences name, n, u, l
        gives_half SUBNH, \name, \n
        gives_half SUBUH, \name, \u
        gives_half SUBLH, \name, \l
        .endm

; ADDN: T := normalised(R + S)
; ADDU: T := upper(R + S)
; ADDL: T := lower(R + S)
; SUBN: T := normalised(R - S)
; SUBU: T := upper(R - S)
; SUBL: T := lower(R - S)
; name, ADDN, ADDU, ADDL
        sums    plain, 3.75, 3.75, zero.92
        sums    mixed, 9.5, 9.5, zero.90
        sums    equal, 6.0, 6.0, zero.91
        sums    opposite, 0.0, zero.45, zero.92
        sums    integers, 8.0, 8, zero.47
        sums    carry, X'0001 7FFF FFFF FFFF', X'0001 7FFF FFFF FFFF', zero.46
        sums    under, X'FFD17FFFFFFFFFFF', X'FFD23FFFFFFFFFFF', X'FFA3400000000000'
        sums    far, X'FFD17FFFFFFFFFFF', X'FFD23FFFFFFFFFFF', X'FFA37FFFFFFFFFFF'
        sums    tenth, X'FFD04CCCCCCCCCCC', X'FFD04CCCCCCCCCCC', X'FFA1400000000000'
        sums    zero_coefficient, 1.0, X'0010 0000 0000 0000', X'FFE1 0000 8000 0000'
        sums    zero_left, 7.0, 7, zero.47
        sums    zero_right, -1.5, -1.5, zero.93
        sums    zero_both, 0.0, 0.0, 0.0
        sums    indefinite, indefinite, indefinite, indefinite
        sums    overflow, X'6FD0800000000000', X'6FFFFFFFFFFFFFFF', X'6FD0000000000000'
        sums    huge, indefinite, indefinite, X'6FD1 0000 0000 0000'
        sums    underflow, X'9001 4000 0000 0000', X'9001 4000 0000 0000', 0.0
; name, SUBN, SUBU, SUBL
        differences plain, -0.75, X'FFD3 E800 0000 0000', zero.92
        differences mixed, 10.5, 10.5, zero.90
        differences equal, 0.0, zero.45, zero.92
        differences opposite, 6.0, 6.0, zero.91
        differences integers, 2.0, 2, zero.47
        differences carry, 0.0, 0, zero.47
        differences under, 1.0, 1.0, X'FFA3 4000 0000 0000'
        differences far, 1.0, 1.0, X'FFA3 0000 0000 0001'
        differences tenth, X'FFCE 9999 9999 999A', X'FFCF CCCC CCCC CCCD', zero.96
        differences zero_coefficient, 1.0, X'0010000000000000', X'FFE1000080000000'
        differences zero_left, -7.0, -7, zero.47
        differences zero_right, -1.5, -1.5, zero.93
        differences zero_both, 0.0, 0.0, 0.0
        differences indefinite, indefinite, indefinite, indefinite
        differences overflow, indefinite, indefinite, X'6FD1 4000 0000 0000'
        differences huge, 0.0, X'6FFF 0000 0000 0000', X'6FD0 0000 0000 0000'
        differences underflow, 0.0, X'9000 0000 0000 0001', 0.0
; name, ADDNH, ADDUH, ADDLH
        half_sums plain, 3.75, 3.75, X'D400 0000'
        half_sums mixed, 9.5, 9.5, X'D600 0000'
        half_sums equal, 6.0, 6.0, X'D500 0000'
        half_sums opposite, 0.0, X'EB00 0000', X'D400 0000'
        half_sums integers, 8.0, 8, X'E900 0000'
        half_sums carry, X'017F FFFF', X'017F FFFF', X'EA00 0000'
        half_sums under, X'E97F FFFF', X'EA3F FFFF', X'D340 0000'
        half_sums far, X'E97F FFFF', X'EA3F FFFF', X'D37F FFFF'
        half_sums tenth, X'E84C CCCC', X'E84C CCCC', X'D140 0000'
        half_sums zero_coefficient, 1.0, X'1000 0000', X'F900 0080'
        half_sums zero_left, 7.0, 7, X'E900 0000'
        half_sums zero_right, -1.5, -1.5, X'D300 0000'
        half_sums zero_both, 0.0, 0.0, 0.0
        half_sums indefinite, X'7000 0000', X'7000 0000', X'7000 0000'
        half_sums overflow, X'5880 0000', X'6FFF FFFF', X'5800 0000'
        half_sums huge, X'7000 0000', X'7000 0000', X'5900 0000'
        half_sums underflow, X'9140 0000', X'9140 0000', 0.0
; name, SUBNH, SUBUH, SUBLH
        half_differences plain, -0.75, X'EBE8 0000', X'D400 0000'
        half_differences mixed, 10.5, 10.5, X'D600 0000'
        half_differences equal, 0.0, X'EB00 0000', X'D400 0000'
        half_differences opposite, 6.0, 6.0, X'D500 0000'
        half_differences integers, 2.0, 2, X'E900 0000'
        half_differences carry, 0.0, 0, X'E900 0000'
        half_differences under, 1.0, 1.0, X'D340 0000'
        half_differences far, 1.0, 1.0, X'D300 0001'
        half_differences tenth, X'E699 999A', X'E7CC CCCD', X'D000 0000'
        half_differences zero_coefficient, 1.0, X'1000 0000', X'F900 0080'
        half_differences zero_left, -7.0, -7, X'E900 0000'
        half_differences zero_right, -1.5, -1.5, X'D300 0000'
        half_differences zero_both, 0.0, 0.0, 0.0
        half_differences indefinite, X'7000 0000', X'7000 0000', X'7000 0000'
        half_differences overflow, X'7000 0000', X'7000 0000', X'5940 0000'
        half_differences huge, 0.0, X'6F00 0000', X'5800 0000'
        half_differences underflow, 0.0, X'9000 0001', 0.0
        zeros_and_flags ADDN, -2.5, -2.5, -2.5, -2.5, X'0000 0000 0032 0000'
        zeros_and_flags ADDU, -2.5, -2.5, -2.5, -2.5, X'0000 0000 0032 0000'
        with_zero ADDL, zero.92, zero.92
        with_zero_half ADDLH, X'D400 0000', X'D400 0000'
        both_flags ADDL, X'0000 0000 0012 0000'
        zeros_and_flags SUBN, 2.5, -2.5, 2.5, -2.5, X'0000 0000 0032 0000'
        zeros_and_flags SUBU, 2.5, -2.5, 2.5, -2.5, X'0000 0000 0032 0000'
        with_zero SUBL, zero.92, zero.92
        with_zero_half SUBLH, X'D400 0000', X'D400 0000'
        both_flags SUBL, X'0000 0000 0012 0000'

; ---- Vectors ----
        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
odd_a:  .word   5, 0.0, 1.0, 3.0, X'6FFF 7FFF FFFF FFFF'
        .word   X'0010 0000 0000 0000'
odd_b:  .word   3, 7, X'7000 0000 0000 0000', -3.0, X'6FFF 7FFF FFFF FFFF', 1.0
        .code
; ADDNV: C := normalised(A + B)
        elements ADDNV, 11.0, -1.5, 0.0, 9.0, 1.5, 99.75
        arithmetic ADDNV, 7.5
; expect: [ADDNV.broadcast_a] = 18.0, 8.5, 5.0, 12.5, 10.0, 7.75
; expect: [ADDNV.broadcast_b] = 0.5, -2.5, 2.5, 4.0, -1.0, 99.5
; expect: [ADDNV.offset_sources] = -5.0, 7.5, 6.5, -0.75, 100.0, 0.0
; expect: [ADDNV.short_sources + 2*64] = 3.0, 4.5, 0.0, 0.0
; expect: [ADDNV.chain] = 1.0, 11.0, 11.5, 8.5, 13.0, 15.0, 14.75
; expect: [ADDNV.negated] = 9.0, 2.5, -6.0, 0.0, 2.5, -100.25
; expect: [ADDNV.magnitudes] = 11.0, 2.5, 6.0, 9.0, 2.5, 100.25
; expect: [ADDNV.negative] = 9.0, -1.5, -6.0, 0.0, 1.5, -100.25
; expect: [ADDNV.negated_scalar] = 2.0, -7.5, -11.0, -3.5, -6.0, -8.25
; expect: [ADDNV.odd] = 8.0, 7.0, indefinite, 0.0, indefinite, 1.0
        flags_are ADDNV, X'0000 0000 0032 0000'
; ADDUV: C := upper(A + B)
        elements ADDUV, 11.0, -1.5, X'FFD3000000000000', 9.0, X'FFD3300000000000', 99.75
        arithmetic ADDUV, X'FFD5 3C00 0000 0000'
; expect: [ADDUV.broadcast_a] = 18.0, 8.5, X'FFD5 2800 0000 0000', 12.5, 10.0
; expect: [ADDUV.broadcast_a + 5*64] = X'FFD5 3E00 0000 0000'
; expect: [ADDUV.broadcast_b] = X'FFD2 2000 0000 0000', -2.5, 2.5, 4.0, -1.0, 99.5
; expect: [ADDUV.offset_sources] = -5.0, 7.5, 6.5, -0.75, 100.0, 0.0
; expect: [ADDUV.short_sources + 2*64] = 3.0, 4.5, 0.0, 0.0
; expect: [ADDUV.chain] = 1.0, 11.0, 11.5, 8.5, 13.0, 15.0, 14.75
; expect: [ADDUV.negated] = 9.0, 2.5, -6.0, zero.44, 2.5, -100.25
; expect: [ADDUV.magnitudes] = 11.0, 2.5, 6.0, 9.0, 2.5, 100.25
; expect: [ADDUV.negative] = 9.0, -1.5, -6.0, zero.44, X'FFD3 3000 0000 0000', -100.25
; expect: [ADDUV.negated_scalar] = X'FFD5 1000 0000 0000', -7.5, -11.0
; expect: [ADDUV.negated_scalar + 3*64] = X'FFD4 C800 0000 0000', -6.0, -8.25
; expect: [ADDUV.odd] = 8, 7, indefinite, zero.45, indefinite, X'0010 0000 0000 0000'
        flags_are ADDUV, X'0000 0000 0032 0000'
; ADDLV: C := lower(A + B)
        elements ADDLV, zero.90, zero.93, zero.92, zero.90, zero.92, zero.87
        arithmetic ADDLV, zero.90
; expect: [ADDLV.broadcast_a] = zero.89, zero.90, zero.90, zero.90, zero.90, zero.90
; expect: [ADDLV.broadcast_b] = zero.93, zero.92, zero.92, zero.91, zero.94, zero.87
; expect: [ADDLV.offset_sources] = zero.91, zero.91, zero.91, zero.94, zero.87, 0.0
; expect: [ADDLV.short_sources + 2*64] = zero.92, zero.91, 0.0, 0.0
; expect: [ADDLV.chain] = 1.0, zero.90, zero.94, zero.92, zero.91, zero.92, zero.96
; expect: [ADDLV.negated] = zero.90, zero.92, zero.91, zero.91, zero.92, zero.87
; expect: [ADDLV.magnitudes] = zero.90, zero.92, zero.91, zero.90, zero.92, zero.87
; expect: [ADDLV.negative] = zero.90, zero.93, zero.91, zero.91, zero.92, zero.87
; expect: [ADDLV.negated_scalar] = zero.90, zero.91, zero.90, zero.91, zero.91, zero.90
; expect: [ADDLV.odd] = zero.47, zero.47, indefinite, zero.92, X'6FD1 0000 0000 0000'
; expect: [ADDLV.odd + 5*64] = X'FFE1 0000 8000 0000'
        flags_are ADDLV, X'0000 0000 0012 0000'
; SUBNV: C := normalised(A - B)
        elements SUBNV, -9.0, -2.5, 6.0, 0.0, -2.5, 100.25
        arithmetic SUBNV, 8.5
; expect: [SUBNV.broadcast_a] = -2.0, 7.5, 11.0, 3.5, 6.0, 8.25
; expect: [SUBNV.broadcast_b] = 1.5, -1.5, 3.5, 5.0, 0.0, 100.5
; expect: [SUBNV.offset_sources] = 1.0, -1.5, 2.5, -0.25, 100.0, 0.0
; expect: [SUBNV.short_sources + 2*64] = 3.0, 4.5, 0.0, 0.0
; expect: [SUBNV.chain] = 1.0, -9.0, -9.5, -6.5, -11.0, -13.0, -12.75
; expect: [SUBNV.negated] = -11.0, 1.5, 0.0, -9.0, -1.5, -99.75
; expect: [SUBNV.magnitudes] = -9.0, 1.5, 0.0, 0.0, -1.5, 99.75
; expect: [SUBNV.negative] = -11.0, -2.5, 0.0, -9.0, -2.5, -99.75
; expect: [SUBNV.negated_scalar] = -18.0, -8.5, -5.0, -12.5, -10.0, -7.75
; expect: [SUBNV.odd] = 2.0, -7.0, indefinite, 6.0, 0.0, -1.0
        flags_are SUBNV, X'0000 0000 0012 0000'
; SUBUV: C := upper(A - B)
        elements SUBUV, -9.0, -2.5, 6.0, X'FFD4 0000 0000 0000', -2.5, 100.25
        arithmetic SUBUV, 8.5
; expect: [SUBUV.broadcast_a] = X'FFD5F00000000000', X'FFD53C0000000000', 11.0
; expect: [SUBUV.broadcast_a + 3*64] = X'FFD51C0000000000', X'FFD5300000000000', 8.25
; expect: [SUBUV.broadcast_b] = 1.5, -1.5, 3.5, 5.0, zero.48, 100.5
; expect: [SUBUV.offset_sources] = X'FFD3 2000 0000 0000', X'FFD4 E800 0000 0000'
; expect: [SUBUV.offset_sources + 2*64] = X'FFD4 2800 0000 0000', X'FFD0 C000 0000 0000'
; expect: [SUBUV.offset_sources + 4*64] = 100.0, 0.0
; expect: [SUBUV.short_sources + 2*64] = 3.0, 4.5, 0.0, 0.0
; expect: [SUBUV.chain] = 1.0, -9.0, -9.5, X'FFD5 CC00 0000 0000', -11.0, -13.0, -12.75
; expect: [SUBUV.negated] = -11.0, X'FFD3 3000 0000 0000', zero.45, -9.0
; expect: [SUBUV.negated + 4*64] = X'FFD3 D000 0000 0000', -99.75
; expect: [SUBUV.magnitudes] = -9.0, X'FFD3 3000 0000 0000', zero.45, zero.44
; expect: [SUBUV.magnitudes + 4*64] = X'FFD3 D000 0000 0000', 99.75
; expect: [SUBUV.negative] = -11.0, -2.5, zero.45, -9.0, -2.5, -99.75
; expect: [SUBUV.negated_scalar] = -18.0, -8.5, -5.0, -12.5, -10.0, -7.75
; expect: [SUBUV.odd] = 2, -7, indefinite, 6.0, X'6FFF000000000000', X'0010FFFFFFFFFFFF'
        flags_are SUBUV, X'0000 0000 0012 0000'
; SUBLV: C := lower(A - B)
        elements SUBLV, zero.90, zero.92, zero.91, zero.91, zero.92, zero.87
        arithmetic SUBLV, zero.90
; expect: [SUBLV.broadcast_a] = zero.90, zero.90, zero.90, zero.90, zero.90, zero.90
; expect: [SUBLV.broadcast_b] = zero.93, zero.93, zero.92, zero.91, zero.95, zero.87
; expect: [SUBLV.offset_sources] = zero.92, zero.91, zero.91, zero.95, zero.87, 0.0
; expect: [SUBLV.short_sources + 2*64] = zero.92, zero.91, 0.0, 0.0
; expect: [SUBLV.chain] = 1.0, zero.90, zero.94, zero.92, zero.91, zero.92, zero.95
; expect: [SUBLV.negated] = zero.90, zero.92, zero.92, zero.90, zero.92, zero.87
; expect: [SUBLV.magnitudes] = zero.90, zero.92, zero.92, zero.91, zero.92, zero.87
; expect: [SUBLV.negative] = zero.90, zero.92, zero.92, zero.90, zero.92, zero.87
; expect: [SUBLV.negated_scalar] = zero.89, zero.90, zero.91, zero.90, zero.90, zero.91
; expect: [SUBLV.odd] = zero.47, zero.47, indefinite, zero.91, X'6FD0 0000 0000 0000'
; expect: [SUBLV.odd + 5*64] = 65535.0
        flags_are SUBLV, X'0000 0000 0012 0000'
; AVGV: C := normalised(A + B) / 2
        elements AVGV, 5.5, -0.75, 0.0, 4.5, 0.75, 49.875
        arithmetic AVGV, 3.75
; expect: [AVGV.broadcast_a] = 9.0, 4.25, 2.5, 6.25, 5.0, 3.875
; expect: [AVGV.broadcast_b] = 0.25, -1.25, 1.25, 2.0, -0.5, 49.75
; expect: [AVGV.offset_sources] = -2.5, 3.75, 3.25, -0.375, 50.0, 0.0
; expect: [AVGV.short_sources + 2*64] = 1.5, 2.25, 0.0, 0.0
; expect: [AVGV.chain] = 1.0, 5.5, 3.0, 0.0, 2.25, 2.125, 0.9375
; expect: [AVGV.negated] = 4.5, 1.25, -3.0, 0.0, 1.25, -50.125
; expect: [AVGV.magnitudes] = 5.5, 1.25, 3.0, 4.5, 1.25, 50.125
; expect: [AVGV.negative] = 4.5, -0.75, -3.0, 0.0, 0.75, -50.125
; expect: [AVGV.negated_scalar] = 1.0, -3.75, -5.5, -1.75, -3.0, -4.125
; expect: [AVGV.odd] = 4.0, 3.5, indefinite, 0.0, indefinite, 0.5
        flags_are AVGV, X'0000 0000 0032 0000'
; AVGDV: C := normalised(A - B) / 2
        elements AVGDV, -4.5, -1.25, 3.0, 0.0, -1.25, 50.125
        arithmetic AVGDV, 4.25
; expect: [AVGDV.broadcast_a] = -1.0, 3.75, 5.5, 1.75, 3.0, 4.125
; expect: [AVGDV.broadcast_b] = 0.75, -0.75, 1.75, 2.5, 0.0, 50.25
; expect: [AVGDV.offset_sources] = 0.5, -0.75, 1.25, -0.125, 50.0, 0.0
; expect: [AVGDV.short_sources + 2*64] = 1.5, 2.25, 0.0, 0.0
; expect: [AVGDV.chain] = 1.0, -4.5, -2.5, 0.25, -2.125, -2.0625, -0.90625
; expect: [AVGDV.negated] = -5.5, 0.75, 0.0, -4.5, -0.75, -49.875
; expect: [AVGDV.magnitudes] = -4.5, 0.75, 0.0, 0.0, -0.75, 49.875
; expect: [AVGDV.negative] = -5.5, -1.25, 0.0, -4.5, -1.25, -49.875
; expect: [AVGDV.negated_scalar] = -9.0, -4.25, -2.5, -6.25, -5.0, -3.875
; expect: [AVGDV.odd] = 1.0, -3.5, indefinite, 3.0, 0.0, -0.5
        flags_are AVGDV, X'0000 0000 0012 0000'
        EXIT
