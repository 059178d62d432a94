; Words combined or shifted bit by bit are compared with words that the assembler
; computes, or that are worked out by hand.  A wrong bit of one operation, and a wrong
; element of one use of a vector, makes a word differ.
; tests: AND OR XOR SHIFT SHIFTI ANDV ORV XORV NANDV NORV ANDNV ORNV EQVV SHIFTV
; warns: recurrence ANDV ORV XORV NANDV NORV ANDNV ORNV EQVV SHIFTV
; warns: zero-length ANDV ORV XORV NANDV NORV ANDNV ORNV EQVV SHIFTV

        .include "scalar.inc"
        .include "binary.inc"

        .macro  combines op, plain, special, none
        two     \op, plain, X'0F0F0F0F0F0F0F0F', X'00FF00FF00FF00FF', \plain
        two     \op, special, X'7000000000000001', X'8000000000000001', \special
        \op     left, r0, result        ; register 0 is 0
        word_is \op, with_none, \none
        \op     left, right, r0
        flags   \op, X'0000 0000 0000 0000'
        .endm

; AND: T := R AND S.  OR: T := R OR S.  XOR: T := R XOR S.
        combines AND, X'000F000F000F000F', 1, 0
        combines OR, X'0FFF0FFF0FFF0FFF', X'F000000000000001', X'7000000000000001'
        combines XOR, X'0FF00FF00FF00FF0', X'F000000000000000', X'7000000000000001'
; SHIFT: T := R shifted by S: left circular, or right (< 0) with the sign
        two     SHIFT, left_4, X'8123 4567 89AB CDEF', 4, X'1234 5678 9ABC DEF8'
        two     SHIFT, none, X'8123 4567 89AB CDEF', 0, X'8123 4567 89AB CDEF'
        two     SHIFT, left_63, 2, 63, 1
        two     SHIFT, right_4, X'8123 4567 89AB CDEF', -4, X'F812 3456 789A BCDE'
        two     SHIFT, right_positive, indefinite, -60, 7
        two     SHIFT, right_64, X'8123 4567 89AB CDEF', -64, X'FFFF FFFF FFFF FFFF'
; counts of 64 and more rotate modulo 64; counts below -64 act like -64
        two     SHIFT, left_68, X'8123 4567 89AB CDEF', 68, X'1234 5678 9ABC DEF8'
        two     SHIFT, right_1000, X'7123 4567 89AB CDEF', -1000, 0
        SHIFT   left, r0, result        ; register 0 is 0
        word_is SHIFT, by_none, X'7123 4567 89AB CDEF'
        SHIFT   left, right, r0
        flags   SHIFT, X'0000 0000 0000 0000'
; SHIFTI: T := R shifted by I8: left circular, or right (< 0) with the sign
        fetch   left, X'8123 4567 89AB CDEF'
        SHIFTI  left, 4, r40
        SHIFTI  left, 0, r41
        SHIFTI  left, 63, r42
        SHIFTI  left, -4, r43
        SHIFTI  left, -63, r44
        SHIFTI  left, -64, r45
        register_is SHIFTI, r40, X'1234 5678 9ABC DEF8'
        register_is SHIFTI, r41, X'8123 4567 89AB CDEF'
        register_is SHIFTI, r42, X'C091 A2B3 C4D5 E6F7'
        register_is SHIFTI, r43, X'F812 3456 789A BCDE'
        register_is SHIFTI, r44, X'FFFF FFFF FFFF FFFF'
        register_is SHIFTI, r45, X'FFFF FFFF FFFF FFFF'
        fetch   left, X'4000 0000 0000 0000'
        SHIFTI  left, -62, r46
        SHIFTI  left, -63, r47
        SHIFTI  left, 2, left           ; the source may be the result
        SHIFTI  left, 1, r0
        register_is SHIFTI, r46, 1
        register_is SHIFTI, r47, 0
        register_is SHIFTI, left, 1
        flags   SHIFTI, X'0000 0000 0000 0000'
; expect: r0 = 0

; ---- Vectors ----
        .equ    a.0, X'0123 4567 89AB CDEF'
        .equ    a.1, X'FFFF FFFF FFFF FFFF'
        .equ    a.2, X'0000 0000 0000 0000'
        .equ    a.3, X'8000 0000 0000 0001'
        .equ    a.4, X'5555 5555 5555 5555'
        .equ    a.5, X'FFFF 0000 FFFF 0000'
        .equ    scalar_a, X'00FF 00FF 00FF 00FF'
        .equ    b.0, X'FEDC BA98 7654 3210'
        .equ    b.1, X'0F0F 0F0F 0F0F 0F0F'
        .equ    b.2, X'0000 0000 0000 0001'
        .equ    b.3, X'8000 0000 0000 0000'
        .equ    b.4, X'3333 3333 3333 3333'
        .equ    b.5, X'0000 FFFF FFFF 0000'
        .equ    scalar_b, X'F0F0 F0F0 F0F0 F0F0'
        .data
a:      .word   a.0, a.1, a.2, a.3, a.4, a.5
b:      .word   b.0, b.1, b.2, b.3, b.4, b.5
scalars:
        .word   scalar_a, scalar_b
        .code

; Combines two words bit by bit; the assembler computes the expected result.
        .macro  bits_of op, use, i, a, b, between, before=
; expect: [\op\().\use + \i*64] = word(\before (bits(\a) \between bits(\b)))
        .endm

        .macro  logical op, between, before=
        .equ    \op\().c1, word(\before (bits(1.0) \between bits(b.0)))
        .equ    \op\().c2, word(\before (bits(\op\().c1) \between bits(b.1)))
        .equ    \op\().c3, word(\before (bits(\op\().c2) \between bits(b.2)))
        .equ    \op\().c4, word(\before (bits(\op\().c3) \between bits(b.3)))
        .equ    \op\().c5, word(\before (bits(\op\().c4) \between bits(b.4)))
        .equ    \op\().c6, word(\before (bits(\op\().c5) \between bits(b.5)))
        .rept   6
        .equ    \op\().\+, word(\before (bits(a.\+) \between bits(b.\+)))
        .endr
        uses    \op, word(\before (bits(scalar_a) \between bits(scalar_b)))
        .rept   6
        bits_of \op, broadcast_a, \+, scalar_a, b.\+, \between, \before
        bits_of \op, broadcast_b, \+, a.\+, scalar_b, \between, \before
        .endr
        bits_of \op, offset_sources, 0, a.1, b.2, \between, \before
        bits_of \op, offset_sources, 1, a.2, b.3, \between, \before
        bits_of \op, offset_sources, 2, a.3, b.4, \between, \before
        bits_of \op, offset_sources, 3, a.4, b.5, \between, \before
        bits_of \op, offset_sources, 4, a.5, 0, \between, \before
        bits_of \op, offset_sources, 5, 0, 0, \between, \before
        bits_of \op, short_sources, 2, a.2, 0, \between, \before
        bits_of \op, short_sources, 3, a.3, 0, \between, \before
        bits_of \op, short_sources, 4, 0, 0, \between, \before
        bits_of \op, short_sources, 5, 0, 0, \between, \before
        overlap \op
; expect: [\op\().chain] = 1.0, \op\().c1, \op\().c2, \op\().c3, \op\().c4
; expect: [\op\().chain + 5*64] = \op\().c5, \op\().c6
        flags_are \op, 0
        .endm

        logical ANDV,   &      ; C := A AND B
        logical ORV,    |      ; C := A OR B
        logical XORV,   ^      ; C := A XOR B
        logical NANDV,  &, ~   ; C := NOT (A AND B)
        logical NORV,   |, ~   ; C := NOT (A OR B)
        logical ANDNV,  & ~    ; C := A AND NOT B
        logical ORNV,   | ~    ; C := A OR NOT B
        logical EQVV,   ^, ~   ; C := NOT (A XOR B)
        .data
shift_a:
        .word   X'0123 4567 89AB CDEF', X'FFFF FFFF FFFF FFFF'
        .word   X'0000 0000 0000 0000', X'8000 0000 0000 0001'
        .word   X'5555 5555 5555 5555', X'FFFF 0000 FFFF 0000'
shift_b:
        .word   4, -4, 63, -1, -64, 64
shift_scalars:
        .word   X'8123 4567 89AB CDEF', -100
        .code
; SHIFTV: C := A shifted by B: left circular, or right (< 0) with the sign
        front   SHIFTV, X'1234 5678 9ABC DEF0', X'FFFF FFFF FFFF FFFF', 0
        back    SHIFTV, X'C000 0000 0000 0000', 0, X'FFFF 0000 FFFF 0000'
        uses    SHIFTV, X'FFFF FFFF FFFF FFFF', shift_
        overlap SHIFTV
; expect: [SHIFTV.broadcast_a] = X'1234 5678 9ABC DEF8', X'F812 3456 789A BCDE'
; expect: [SHIFTV.broadcast_a + 2*64] = X'C091 A2B3 C4D5 E6F7', X'C091 A2B3 C4D5 E6F7'
; expect: [SHIFTV.broadcast_a + 4*64] = X'FFFF FFFF FFFF FFFF', X'8123 4567 89AB CDEF'
; expect: [SHIFTV.broadcast_b] = 0, X'FFFF FFFF FFFF FFFF', 0, X'FFFF FFFF FFFF FFFF', 0
; expect: [SHIFTV.broadcast_b + 5*64] = X'FFFF FFFF FFFF FFFF'
; expect: [SHIFTV.offset_sources] = X'FFFFFFFFFFFFFFFF', 0, X'FFFFFFFFFFFFFFFF'
; expect: [SHIFTV.offset_sources + 3*64] = X'5555555555555555', X'FFFF0000FFFF0000', 0
; expect: [SHIFTV.short_sources + 2*64] = 0, X'8000 0000 0000 0001', 0, 0
; expect: [SHIFTV.chain] = 1.0, X'FD24 0000 0000 000F', 1.0, X'7FE9 2000 0000 0000'
; expect: [SHIFTV.chain + 4*64] = X'3FF4 9000 0000 0000', 0, 0
        flags_are SHIFTV, X'0000 0000 0000 0000'
        EXIT
