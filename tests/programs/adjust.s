; Numbers with another exponent are compared with words worked out by hand: shifts to
; both sides, the ends of the exponent range, specials, register 0, every use of a
; vector.  A wrong shift, cut, overflow or data flag of one form makes a word differ.
; tests: ADJE ADJEH ADJEV ADJS ADJSH ADJSV PACK PACKH PACKV
; warns: recurrence ADJEV ADJSV PACKV
; warns: zero-length ADJEV ADJSV PACKV

        .include "scalar.inc"
        .include "binary.inc"

; specials become the plain words
        sized_pair zero, X'8123 0000 0000 0005', 3, X'8000 0005', 3
        sized_pair indefinite, X'7123 0000 0000 0005', -3, X'7000 0005', -3
; ADJE: T := R with the exponent S, its coefficient shifted to suit;
; indefinite if it does not fit
        both_two ADJE, left_3, 5, -3, X'FFFD 0000 0000 0028', X'FD00 0028'
; right shift: bits that leave the coefficient are lost (floor)
        both_two ADJE, integer, 1.0, 0, 1, 1
        both_two ADJE, fraction, 2.75, 0, 2, 2
        both_two ADJE, negative, -2.75, 0, -3, -3
        both_two ADJE, all_lost, -5, 100, X'0064 FFFF FFFF FFFF', X'64FF FFFF'
        sized_two ADJE, same, 1.0, -46, 1.0, 1.0, -22, 1.0
; coefficients that just fit, and coefficients that do not fit
        sized_two ADJE, fits, 1, -46, 1.0, 1, -22, 1.0
        two     ADJE, minus_one, -1, -47, X'FFD1 8000 0000 0000'
        two_half ADJEH, minus_one, -1, -23, X'E980 0000'
        sized_two ADJE, too_long, 1, -47, indefinite, 1, -23, X'7000 0000'
        both_two ADJE, far_too_long, 1, -40000, indefinite, X'7000 0000'
        two     ADJE, zero_coefficient, X'0010000000000000', -100, X'FF9C000000000000'
        two_half ADJEH, zero_coefficient, X'1000 0000', -100, X'9C00 0000'
; only the low 48 bits of S are used
        two     ADJE, low_bits, 5, X'1234 FFFF FFFF FFFD', X'FFFD 0000 0000 0028'
        two_half ADJEH, low_bits, 5, X'ECFF FFFD', X'FD00 0028'
; the exponent leaves its range
        sized_two ADJE, overflow, 5, 28672, indefinite, 5, 112, X'7000 0000'
        two     ADJE, underflow, X'9000 0000 0000 0001', -28673, 0.0
        two_half ADJEH, underflow, X'9000 0001', -113, 0.0
        two     ADJE, zero_underflow, X'0010 0000 0000 0000', -40000, 0.0
        two_half ADJEH, zero_underflow, X'1000 0000', -40000, 0.0
        gives_both ADJE, zero, 0.0, 0.0
        gives_both ADJE, indefinite, indefinite, X'7000 0000'
; register 0 is 0 as S
        fetch   left, 12.5
        ADJE    left, r0, result
        word_is ADJE, register_zero, 12
        fetch_half half_left, 12.5
        ADJEH   half_left, h0, half_result
        half_is ADJEH, register_zero, 12
        both_flags ADJE, X'0000 0000 0032 0000'
; ADJS: T := R, its coefficient shifted left by S, at most normalised, or right (< 0)
        both_two ADJS, left_3, 5, 3, X'FFFD 0000 0000 0028', X'FD00 0028'
        both_two ADJS, normalised, 5, 100, X'FFD4 5000 0000 0000', X'EC50 0000'
        both_two ADJS, as_it_is, 1.0, 5, 1.0, 1.0
        both_two ADJS, minus_one, -1, 47, X'FFD1 8000 0000 0000', X'E980 0000'
; right shift: bits that leave the coefficient are lost (floor)
        both_two ADJS, right_2, 13, -2, X'0002 0000 0000 0003', X'0200 0003'
        both_two ADJS, negative, -13, -2, X'0002 FFFF FFFF FFFC', X'02FF FFFC'
        both_two ADJS, all_lost, 5, -50, X'0032 0000 0000 0000', X'3200 0000'
        both_two ADJS, sign_left, -5, -50, X'0032 FFFF FFFF FFFF', X'32FF FFFF'
; a coefficient of 0 is shifted by at most 47 places
        two     ADJS, zero_coefficient, X'0010000000000000', 60, X'FFE1000000000000'
        two_half ADJSH, zero_coefficient, X'1000 0000', 60, X'F900 0000'
; only the low 48 bits of S are used
        two     ADJS, low_bits, 5, X'1234 0000 0000 0003', X'FFFD 0000 0000 0028'
        two_half ADJSH, low_bits, 5, X'EC00 0003', X'FD00 0028'
; the exponent leaves its range
        sized_two ADJS, underflow, X'9000 0000 0000 0005', 1, 0.0, X'9000 0005', 1, 0.0
        two     ADJS, overflow, X'6FFF 0000 0000 0005', -1, indefinite
        two_half ADJSH, overflow, X'6F00 0005', -1, X'7000 0000'
        two     ADJS, furthest, 5, X'0000 8000 0000 0000', indefinite
        two_half ADJSH, furthest, 5, X'0080 0000', X'7000 0000'
        gives_both ADJS, zero, 0.0, 0.0
        gives_both ADJS, indefinite, indefinite, X'7000 0000'
; register 0 is machine zero as R and 0 as S
        ADJS    r0, right, result
        word_is ADJS, of_register_zero, 0.0
        fetch   left, 5
        ADJS    left, r0, result
        word_is ADJS, by_register_zero, 5
        ADJSH   h0, half_right, half_result
        half_is ADJSH, of_register_zero, 0.0
        fetch_half half_left, 5
        ADJSH   half_left, h0, half_result
        half_is ADJSH, by_register_zero, 5
        both_flags ADJS, X'0000 0000 0032 0000'
; PACK: T := low 16 bits of R, followed by low 48 bits of S
        sized_two PACK, plain, -46, X'0000 4000 0000 0000', 1.0, -22, X'0040 0000', 1.0
        both_two PACK, other_exponent, 3, 1.0, X'0003 4000 0000 0000', X'0340 0000'
        two     PACK, low_bits, X'1234000000018000', X'5678000000000007', X'8000000000000007'
        two_half PACKH, low_bits, X'1234 5680', X'5600 0007', X'8000 0007'
        two     PACK, negative, 28671, -1, X'6FFF FFFF FFFF FFFF'
        two_half PACKH, negative, 111, -1, X'6FFF FFFF'
; PACK treats no word as special and sets no data flag
        two     PACK, indefinite, X'7000000000007000', indefinite, indefinite
        two_half PACKH, indefinite, X'7000 0070', X'7000 0000', X'7000 0000'
; register 0 is 0
        PACK    left, r0, result
        word_is PACK, register_zero, indefinite
        PACKH   half_left, h0, half_result
        half_is PACKH, register_zero, X'7000 0000'
        both_flags PACK, X'0000 0000 0000 0000'

; ---- Vectors ----
        .data
e_a:    .word   5, -13, 1.0, 12, 100, 7
e_b:    .word   -3, 2, 0, -1, 3, 0
e_scalars:
        .word   6, 1
e_odd_a:
        .word   X'7123 0000 0000 0001', 5, X'8123 0000 0000 0005'
e_odd_b:
        .word   1, -47, 5
        .code
; ADJEV: C := A with the exponents B, its coefficients shifted to suit;
; indefinite where one does not fit
        front   ADJEV, X'FFFD 0000 0000 0028', X'0002 FFFF FFFF FFFC', 1
        back    ADJEV, X'FFFF 0000 0000 0018', X'0003 0000 0000 000C', 7
        uses    ADJEV, X'0001 0000 0000 0003', e_
        overlap ADJEV
        signs   ADJEV
        specials ADJEV, 3, e_
; expect: [ADJEV.broadcast_a] = X'FFFD 0000 0000 0030', X'0002 0000 0000 0001', 6
; expect: [ADJEV.broadcast_a + 3*64] = X'FFFF 0000 0000 000C', X'0003 0000 0000 0000', 6
; expect: [ADJEV.broadcast_b] = X'0001 0000 0000 0002', X'0001 FFFF FFFF FFF9'
; expect: [ADJEV.broadcast_b + 2*64] = X'0001 0000 0000 0000', X'0001 0000 0000 0006'
; expect: [ADJEV.broadcast_b + 4*64] = X'0001 0000 0000 0032', X'0001 0000 0000 0003'
; expect: [ADJEV.offset_sources] = -13, X'FFFF 0000 0000 0002', X'0003 0000 0000 0001'
; expect: [ADJEV.offset_sources + 3*64] = 100, 7, 0.0
; expect: [ADJEV.short_sources + 2*64] = 1, 12, 0.0, 0.0
; expect: [ADJEV.chain] = 1.0, X'FFFD 0000 0000 0008', X'0002 0000 0000 0000', 0, zero.1
; expect: [ADJEV.chain + 5*64] = X'0003 0000 0000 0000', 0
; expect: [ADJEV.negated] = X'FFFD FFFF FFFF FFD8', X'0002 0000 0000 0003', -1
; expect: [ADJEV.negated + 3*64] = X'FFFF FFFF FFFF FFE8', X'0003 FFFF FFFF FFF3', -7
; expect: [ADJEV.magnitudes] = X'0003 0000 0000 0000', X'0002 0000 0000 0003', 1
; expect: [ADJEV.magnitudes + 3*64] = X'0001 0000 0000 0006', X'0003 0000 0000 000C', 7
; expect: [ADJEV.negative] = X'FFFD FFFF FFFF FFD8', X'0002 FFFF FFFF FFFC', -1
; expect: [ADJEV.negative + 3*64] = X'FFFF FFFF FFFF FFE8', X'0003 FFFF FFFF FFF3', -7
; expect: [ADJEV.negated_scalar] = X'FFFDFFFFFFFFFFD0', X'0002FFFFFFFFFFFE', -6
; expect: [ADJEV.negated_scalar + 3*64] = X'FFFFFFFFFFFFFFF4', X'0003FFFFFFFFFFFF', -6
; expect: [ADJEV.odd] = indefinite, indefinite, 0.0
        flags_are ADJEV, X'0000 0000 0032 0000'
        .data
s_a:    .word   5, -13, 1.0, 12, 100, 7
s_b:    .word   3, -2, 5, 1, -3, 0
s_scalars:
        .word   6, -1
s_odd_a:
        .word   X'7123 0000 0000 0001', X'6FFF 0000 0000 0005', 5
s_odd_b:
        .word   1, -1, X'7000 0000 0000 0003'
        .code
; ADJSV: C := A, its coefficients shifted left by B, no further than
; normalised, or right (negative)
        front   ADJSV, X'FFFD 0000 0000 0028', X'0002 FFFF FFFF FFFC', 1.0
        back    ADJSV, X'FFFF 0000 0000 0018', X'0003 0000 0000 000C', 7
        uses    ADJSV, X'0001 0000 0000 0003', s_
        overlap ADJSV
        signs   ADJSV
        specials ADJSV, 3, s_
; expect: [ADJSV.broadcast_a] = X'FFFD 0000 0000 0030', X'0002 0000 0000 0001'
; expect: [ADJSV.broadcast_a + 2*64] = X'FFFB 0000 0000 00C0', X'FFFF 0000 0000 000C'
; expect: [ADJSV.broadcast_a + 4*64] = X'0003 0000 0000 0000', 6
; expect: [ADJSV.broadcast_b] = X'0001 0000 0000 0002', X'0001 FFFF FFFF FFF9'
; expect: [ADJSV.broadcast_b + 2*64] = X'FFD3 2000 0000 0000', X'0001 0000 0000 0006'
; expect: [ADJSV.broadcast_b + 4*64] = X'0001 0000 0000 0032', X'0001 0000 0000 0003'
; expect: [ADJSV.offset_sources] = X'FFFB FFFF FFFF FE60', 1.0, X'0003 0000 0000 0001'
; expect: [ADJSV.offset_sources + 3*64] = 100, 7, 0.0
; expect: [ADJSV.short_sources + 2*64] = 1.0, 12, 0.0, 0.0
; expect: [ADJSV.chain] = 1.0, 1.0, X'FFD4 1000 0000 0000', 1.0, 1.0
; expect: [ADJSV.chain + 5*64] = X'FFD5 0800 0000 0000', X'FFD5 0800 0000 0000'
; expect: [ADJSV.negated] = X'FFFD FFFF FFFF FFD8', X'0002 0000 0000 0003', -1.0
; expect: [ADJSV.negated + 3*64] = X'FFFF FFFF FFFF FFE8', X'0003 FFFF FFFF FFF3', -7
; expect: [ADJSV.magnitudes] = X'FFFD 0000 0000 0028', X'FFFE 0000 0000 0034', 1.0
; expect: [ADJSV.magnitudes + 3*64] = X'FFFF 0000 0000 0018', X'FFFD 0000 0000 0320', 7
; expect: [ADJSV.negative] = X'FFFD FFFF FFFF FFD8', X'0002 FFFF FFFF FFFC', -1.0
; expect: [ADJSV.negative + 3*64] = X'FFFF FFFF FFFF FFE8', X'0003 FFFF FFFF FFF3', -7
; expect: [ADJSV.negated_scalar] = X'FFFD FFFF FFFF FFD0', X'0002 FFFF FFFF FFFE'
; expect: [ADJSV.negated_scalar + 2*64] = X'FFFB FFFF FFFF FF40', X'FFFF FFFF FFFF FFF4'
; expect: [ADJSV.negated_scalar + 4*64] = X'0003 FFFF FFFF FFFF', -6
; expect: [ADJSV.odd] = indefinite, indefinite, X'FFFD000000000028'
        flags_are ADJSV, X'0000 0000 0032 0000'
        .data
pack_a: .word   -46, -45, 3, 0, X'1234 0000 0000 8000', 7
pack_b: .word   X'1111 4000 0000 0000', X'2222 4000 0000 0000', -5, 6, 7
        .word   X'3333 2000 0000 0000'
pack_scalars:
        .word   -46, X'5555 4000 0000 0001'
        .code
; PACKV: C := low 16 bits of A as exponents, coefficients of B
        front   PACKV, 1.0, 2.0, X'0003 FFFF FFFF FFFB'
        back    PACKV, 6, X'8000 0000 0000 0007', X'0007 2000 0000 0000'
        uses    PACKV, X'FFD2 4000 0000 0001', pack_
        overlap PACKV
; expect: [PACKV.broadcast_a] = 1.0, 1.0, X'FFD2 FFFF FFFF FFFB', X'FFD2 0000 0000 0006'
; expect: [PACKV.broadcast_a + 4*64] = X'FFD2 0000 0000 0007', X'FFD2 2000 0000 0000'
; expect: [PACKV.broadcast_b] = X'FFD2 4000 0000 0001', X'FFD3 4000 0000 0001'
; expect: [PACKV.broadcast_b + 2*64] = X'0003 4000 0000 0001', X'0000 4000 0000 0001'
; expect: [PACKV.broadcast_b + 4*64] = X'8000 4000 0000 0001', X'0007 4000 0000 0001'
; expect: [PACKV.offset_sources] = X'FFD3FFFFFFFFFFFB', X'0003000000000006', 7
; expect: [PACKV.offset_sources + 3*64] = X'8000200000000000', X'0007000000000000', 0
; expect: [PACKV.short_sources + 2*64] = X'0003 0000 0000 0000', 0, 0, 0
; expect: [PACKV.chain] = 1.0, X'0000 4000 0000 0000', X'0000 4000 0000 0000'
; expect: [PACKV.chain + 3*64] = X'0000 FFFF FFFF FFFB', X'FFFB 0000 0000 0006'
; expect: [PACKV.chain + 5*64] = X'0006 0000 0000 0007', X'0007 2000 0000 0000'
        flags_are PACKV, X'0000 0000 0000 0000'
        EXIT
