; Sums, differences and products of 48-bit integers are compared with words worked out
; by hand: both signs, overflow, descriptors, every use of a vector.  A carry into the
; high 16 bits, or a lost sign, makes a word differ.
; tests: ADDX SUBX MPYX ADDXV SUBXV
; warns: recurrence ADDXV SUBXV
; warns: zero-length ADDXV SUBXV

        .include "scalar.inc"
        .include "binary.inc"

; ADDX: T := low 48 bits of R + S; high 16 bits from R
        two     ADDX, plain, 5, 7, 12
        two     ADDX, negative, 5, -7, X'0000 FFFF FFFF FFFE'
        two     ADDX, wrapped, X'0000 FFFF FFFF FFFF', 2, 1
; a descriptor keeps its length
        two     ADDX, moved, X'0064000000001000', X'FFFF000000000040', X'0064000000001040'
        two     ADDX, no_carry, X'0001 FFFF FFFF FFFF', 1, X'0001 0000 0000 0000'
        ADDX    left, r0, result        ; register 0 is 0
        word_is ADDX, moved_by_none, X'0001 FFFF FFFF FFFF'
        ADDX    left, left, r0
        flags   ADDX, X'0000 0000 0000 0000'
; SUBX: T := low 48 bits of R - S; high 16 bits from R
        two     SUBX, plain, 12, 7, 5
        two     SUBX, negative, 5, 7, X'0000 FFFF FFFF FFFE'
        two     SUBX, minus_negative, 5, -7, 12
; a descriptor keeps its length
        two     SUBX, moved, X'0064000000001040', X'FFFF000000000040', X'0064000000001000'
        two     SUBX, no_borrow, X'0001 0000 0000 0000', 1, X'0001 FFFF FFFF FFFF'
        SUBX    r0, right, result       ; register 0 is 0
        word_is SUBX, from_none, X'0000 FFFF FFFF FFFF'
        SUBX    left, right, r0
        flags   SUBX, X'0000 0000 0000 0000'
; MPYX: T := low 48 bits of R x S; high 16 bits zero
        two     MPYX, plain, 6, 7, 42
        two     MPYX, negative, -6, 7, X'0000 FFFF FFFF FFD6'
        two     MPYX, both_negative, -6, -7, 42
; 2^30 x (2^30 + 5) = 2^60 + 5 x 2^30
        two     MPYX, cut, X'0000000040000000', X'0000000040000005', X'0000000140000000'
        two     MPYX, high_bits, X'1234 0000 0000 0003', X'FFFF 0000 0000 0005', 15
        MPYX    left, r0, result        ; register 0 is 0
        word_is MPYX, by_none, 0
        MPYX    left, right, r0
        flags   MPYX, X'0000 0000 0000 0000'
; expect: r0 = 0

; ---- Vectors ----
        .data
a:      .word   5, -7, X'0064 0000 0000 1000', X'0001 FFFF FFFF FFFF', 100, 0
b:      .word   7, 3, X'FFFF 0000 0000 0040', 1, -100, 8
scalars:
        .word   10, -1
        .code
; ADDXV: C := low 48 bits of A + B; high 16 bits from A
        elements ADDXV, 12, -4, X'0064 0000 0000 1040', X'0001 0000 0000 0000', 0, 8
        uses    ADDXV, 9
        overlap ADDXV
; expect: [ADDXV.broadcast_a] = 17, 13, 74, 11, -90, 18
; expect: [ADDXV.broadcast_b] = 4, -8, X'0064000000000FFF', X'0001FFFFFFFFFFFE', 99, -1
; expect: [ADDXV.offset_sources] = 57, X'0064 0000 0000 1001', X'0001 FFFF FFFF FF9B'
; expect: [ADDXV.offset_sources + 3*64] = 108, 0, 0
; expect: [ADDXV.short_sources + 2*64] = X'0064000000001000', X'0001FFFFFFFFFFFF', 0, 0
; expect: [ADDXV.chain] = 1.0, X'FFD2 4000 0000 0007', X'FFD2 4000 0000 000A'
; expect: [ADDXV.chain + 3*64] = X'FFD2 4000 0000 004A', X'FFD2 4000 0000 004B'
; expect: [ADDXV.chain + 5*64] = X'FFD2 3FFF FFFF FFE7', X'FFD2 3FFF FFFF FFEF'
        flags_are ADDXV, X'0000 0000 0000 0000'
; SUBXV: C := low 48 bits of A - B; high 16 bits from A
        elements SUBXV, -2, -10, X'0064 0000 0000 0FC0', X'0001 FFFF FFFF FFFE', 200, -8
        uses    SUBXV, 11
        overlap SUBXV
; expect: [SUBXV.broadcast_a] = 3, 7, -54, 9, 110, 2
; expect: [SUBXV.broadcast_b] = 6, -6, X'0064000000001001', X'0001000000000000', 101, 1
; expect: [SUBXV.offset_sources] = -71, X'0064 0000 0000 0FFF', X'0001 0000 0000 0063'
; expect: [SUBXV.offset_sources + 3*64] = 92, 0, 0
; expect: [SUBXV.short_sources + 2*64] = X'0064000000001000', X'0001FFFFFFFFFFFF', 0, 0
; expect: [SUBXV.chain] = 1.0, X'FFD2 3FFF FFFF FFF9', X'FFD2 3FFF FFFF FFF6'
; expect: [SUBXV.chain + 3*64] = X'FFD2 3FFF FFFF FFB6', X'FFD2 3FFF FFFF FFB5'
; expect: [SUBXV.chain + 5*64] = X'FFD2 4000 0000 0019', X'FFD2 4000 0000 0011'
        flags_are SUBXV, X'0000 0000 0000 0000'
        EXIT
