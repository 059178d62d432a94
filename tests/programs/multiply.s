; The products of the pairs in the table, and of vectors, are compared with words worked
; out from the rules of docs/arithmetic.md.  A wrong coefficient, number of significant
; bits, special value, sign, length or data flag of one form makes a word differ.
; tests: MPYS MPYU MPYL MPYSH MPYUH MPYLH MPYSV MPYUV MPYLV
; warns: integer-operand MPYS MPYU MPYSH MPYUH MPYSV MPYUV
; warns: recurrence MPYSV MPYUV MPYLV
; warns: zero-length MPYSV MPYUV MPYLV

        .include "scalar.inc"
        .include "binary.inc"

        pair    plain, 1.5, 2.25
        pair    mixed, -0.5, 10.0
; unnormalised: integers
        pair    integers, 6, 7
        words   long, X'0000 7FFF FFFF FFFF', X'0000 7FFF FFFF FFFF'
        halves  long, X'007F FFFF', X'007F FFFF'
; the only product that does not fit in 94 bits
        words   least, X'0000 8000 0000 0000', X'0000 8000 0000 0000'
        halves  least, X'0080 0000', X'0080 0000'
; inexact: rounded down (floor)
        pair    negative, 0.1, -0.3
; as many significant bits as the less significant operand
        pair    less_significant, 5, 0.1
; -1 has no significant bit
        pair    minus_one, -1, -1
        sized_pair zero_coefficient, 1.0, X'0010 0000 0000 0000', 1.0, X'1000 0000'
        pair    zero_left, 0.0, 7
        pair    zero_right, -1.5, 0.0
        sized_pair indefinite, X'7000 0000 0000 0000', 0.0, X'7000 0000', 0.0
; at the ends of the exponent range
        sized_pair overflow, X'6FFF 7FFF FFFF FFFF', 8.0, X'6F7F FFFF', 8.0
        sized_pair underflow, X'9000 4000 0000 0000', 0.25, X'9040 0000', 0.25
        .macro  products name, s, u, l
        gives   MPYS, \name, \s
        gives   MPYU, \name, \u
        gives   MPYL, \name, \l
        .endm

        .macro  half_products name, s, u, l
        gives_half MPYSH, \name, \s
        gives_half MPYUH, \name, \u
        gives_half MPYLH, \name, \l
        .endm

; MPYS: T := significant(R x S)
; MPYU: T := upper(R x S)
; MPYL: T := lower(R x S)
; name, MPYS, MPYU, MPYL
        products plain, 3.375, X'FFD4 3600 0000 0000', zero.91
        products mixed, -5.0, -5.0, zero.91
        products integers, X'0003 0000 0000 0005', X'002F 0000 0000 0000', 42
        products long, X'002F 7FFF FFFF FFFE', X'002F 7FFF FFFF FFFE', 1
        products least, X'0030 4000 0000 0000', X'0030 4000 0000 0000', 0
        products negative, X'FFCC851EB851EB85', X'FFCDC28F5C28F5C2', X'FF9E51EB851EB852'
        products less_significant, X'FFFC000000000007', X'FFFD000000000003', X'FFCE7FFFFFFFFFFE'
        products minus_one, 1, X'002F 0000 0000 0000', 1
        products zero_coefficient, 0.0, X'0011 0000 0000 0000', zero.30
        products zero_left, 0.0, 0.0, 0.0
        products zero_right, 0.0, 0.0, 0.0
        products indefinite, indefinite, indefinite, indefinite
        products overflow, indefinite, indefinite, X'6FD4 4000 0000 0000'
        products underflow, 0.0, 0.0, 0.0
; name, MPYSH, MPYUH, MPYLH
        half_products plain, 3.375, X'EC36 0000', X'D500 0000'
        half_products mixed, -5.0, -5.0, X'D500 0000'
        half_products integers, X'0300 0005', X'1700 0000', 42
        half_products long, X'177F FFFE', X'177F FFFE', 1
        half_products least, X'1840 0000', X'1840 0000', 0
        half_products negative, X'E485 1EB8', X'E5C2 8F5C', X'CE1E B852'
        half_products less_significant, X'FC00 0007', X'FD00 0003', X'E67F FFFE'
        half_products minus_one, 1, X'1700 0000', 1
        half_products zero_coefficient, 0.0, X'1100 0000', X'FA00 0000'
        half_products zero_left, 0.0, 0.0, 0.0
        half_products zero_right, 0.0, 0.0, 0.0
        half_products indefinite, X'7000 0000', X'7000 0000', X'7000 0000'
        half_products overflow, X'7000 0000', X'7000 0000', X'5C40 0000'
        half_products underflow, 0.0, 0.0, 0.0
        zeros_and_flags MPYS, 0.0, 0.0, 0.0, 0.0, X'0000 0000 0032 0000'
        zeros_and_flags MPYU, 0.0, 0.0, 0.0, 0.0, X'0000 0000 0032 0000'
        zeros_and_flags MPYL, 0.0, 0.0, 0.0, 0.0, X'0000 0000 0012 0000'

; ---- Vectors ----
        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
odd_a:  .word   6, 0.0, 1.0, X'0000 8000 0000 0000', X'6FFF 7FFF FFFF FFFF'
        .word   X'9000 4000 0000 0000'
odd_b:  .word   7, 7, X'7000 0000 0000 0000', X'0000 8000 0000 0000', 8.0, 0.25
        .code
; MPYSV: C := significant(A x B)
        elements MPYSV, 10.0, -1.0, -9.0, 20.25, -1.0, -25.0
        arithmetic MPYSV, -4.0
; expect: [MPYSV.broadcast_a] = 80.0, 4.0, -24.0, 36.0, 16.0, -2.0
; expect: [MPYSV.broadcast_b] = -0.5, 1.0, -1.5, -2.25, 0.25, -50.0
; expect: [MPYSV.offset_sources] = 6.0, 13.5, 9.0, 0.125, 100.0, 1.0
; expect: [MPYSV.short_sources + 2*64] = 3.0, 4.5, 1.0, 1.0
; expect: [MPYSV.chain] = 1.0, 10.0, 5.0, -15.0, -67.5, -135.0, 33.75
; expect: [MPYSV.negated] = -10.0, 1.0, 9.0, -20.25, 1.0, 25.0
; expect: [MPYSV.magnitudes] = 10.0, 1.0, 9.0, 20.25, 1.0, 25.0
; expect: [MPYSV.negative] = -10.0, -1.0, 9.0, -20.25, -1.0, 25.0
; expect: [MPYSV.negated_scalar] = -80.0, -4.0, 24.0, -36.0, -16.0, 2.0
; expect: [MPYSV.odd] = X'0003 0000 0000 0005', 0.0, indefinite, X'0030 4000 0000 0000'
; expect: [MPYSV.odd + 4*64] = indefinite, 0.0
        flags_are MPYSV, X'0000 0000 0032 0000'
; MPYUV: C := upper(A x B)
        front   MPYUV, X'FFD6 2800 0000 0000', X'FFD2 C000 0000 0000', -9.0
        back    MPYUV, X'FFD7 2880 0000 0000', X'FFD2 C000 0000 0000', -25.0
        arithmetic MPYUV, X'FFD4 C000 0000 0000'
; expect: [MPYUV.broadcast_a] = X'FFD9 2800 0000 0000', X'FFD5 2000 0000 0000'
; expect: [MPYUV.broadcast_a + 2*64] = X'FFD7 D000 0000 0000', X'FFD8 2400 0000 0000'
; expect: [MPYUV.broadcast_a + 4*64] = X'FFD7 2000 0000 0000', X'FFD3 C000 0000 0000'
; expect: [MPYUV.broadcast_b] = X'FFD1 C000 0000 0000', 1.0, -1.5, -2.25, 0.25, -50.0
; expect: [MPYUV.offset_sources] = 6.0, X'FFD6360000000000', X'FFD6240000000000', 0.125
; expect: [MPYUV.offset_sources + 4*64] = X'FFD9320000000000', X'FFD3200000000000'
; expect: [MPYUV.short_sources + 2*64] = X'FFD4 3000 0000 0000', X'FFD5 2400 0000 0000'
; expect: [MPYUV.short_sources + 4*64] = X'FFD3 2000 0000 0000', X'FFD3 2000 0000 0000'
; expect: [MPYUV.chain] = 1.0, X'FFD6 2800 0000 0000', X'FFD6 1400 0000 0000'
; expect: [MPYUV.chain + 3*64] = X'FFD8 F100 0000 0000', X'FFDB F790 0000 0000'
; expect: [MPYUV.chain + 5*64] = X'FFDD FBC8 0000 0000', X'FFDB 0438 0000 0000'
; expect: [MPYUV.negated] = -10.0, X'FFD3 2000 0000 0000', 9.0, X'FFD7 D780 0000 0000'
; expect: [MPYUV.negated + 4*64] = X'FFD3 2000 0000 0000', 25.0
; expect: [MPYUV.magnitudes] = X'FFD6 2800 0000 0000', X'FFD3 2000 0000 0000', 9.0
; expect: [MPYUV.magnitudes + 3*64] = X'FFD7 2880 0000 0000', X'FFD3 2000 0000 0000'
; expect: [MPYUV.magnitudes + 5*64] = X'FFD7 3200 0000 0000'
; expect: [MPYUV.negative] = -10.0, X'FFD2 C000 0000 0000', 9.0, X'FFD7 D780 0000 0000'
; expect: [MPYUV.negative + 4*64] = X'FFD2 C000 0000 0000', 25.0
; expect: [MPYUV.negated_scalar] = -80.0, X'FFD4 C000 0000 0000', 24.0, -36.0
; expect: [MPYUV.negated_scalar + 4*64] = X'FFD6 C000 0000 0000', 2.0
; expect: [MPYUV.odd] = X'002F 0000 0000 0000', 0.0, indefinite, X'0030 4000 0000 0000'
; expect: [MPYUV.odd + 4*64] = indefinite, 0.0
        flags_are MPYUV, X'0000 0000 0032 0000'
; MPYLV: C := lower(A x B)
        elements MPYLV, zero.89, zero.93, zero.90, zero.88, zero.93, zero.89
        arithmetic MPYLV, zero.91
; expect: [MPYLV.broadcast_a] = zero.86, zero.90, zero.88, zero.87, zero.88, zero.92
; expect: [MPYLV.broadcast_b] = zero.94, zero.94, zero.93, zero.92, zero.96, zero.88
; expect: [MPYLV.offset_sources] = zero.91, zero.89, zero.89, zero.97, zero.86, zero.92
; expect: [MPYLV.short_sources + 2*64] = zero.91, zero.90, zero.92, zero.92
; expect: [MPYLV.chain] = 1.0, zero.89, zero.136, zero.181, zero.225, zero.270, zero.319
; expect: [MPYLV.negated] = zero.90, zero.92, zero.90, zero.88, zero.92, zero.89
; expect: [MPYLV.magnitudes] = zero.89, zero.92, zero.90, zero.88, zero.92, zero.88
; expect: [MPYLV.negative] = zero.90, zero.93, zero.90, zero.88, zero.93, zero.89
; expect: [MPYLV.negated_scalar] = zero.87, zero.91, zero.89, zero.88, zero.89, zero.93
; expect: [MPYLV.odd] = 42, 0.0, indefinite, 0, X'6FD4 4000 0000 0000', 0.0
        flags_are MPYLV, X'0000 0000 0012 0000'
        EXIT
; expect-warning: integer-operand
