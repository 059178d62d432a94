; SQRTV: C := square root of A

        .include "unary.inc"

        .data
a:      .word   4.0, 2.0, 0.0625, -1.0, 100.0, 6.25
scalars:
        .word   8.0, 0.0
        .bitvector z, n, "101100"
        .code

        uses    SQRTV
; expect: [plain] = 2.0, X'FFD2 5A82 7999 FCEF', 0.25, X'7000 0000 0000 0000'
; expect: [plain + 4*64] = 10.0, 2.5
; expect: [broadcast] = X'FFD3 5A82 7999 FCEF', X'FFD3 5A82 7999 FCEF'
; expect: [broadcast + 2*64] = X'FFD3 5A82 7999 FCEF', X'FFD3 5A82 7999 FCEF'
; expect: [broadcast + 4*64] = X'FFD3 5A82 7999 FCEF', X'FFD3 5A82 7999 FCEF'
; expect: [where_ones] = 2.0, 9.0, 0.25, X'7000 0000 0000 0000', 9.0, 9.0
; expect: [where_zeros] = 9.0, X'FFD2 5A82 7999 FCEF', 9.0, 9.0, 10.0, 2.5
; expect: [offset_source] = 0.25, X'7000 0000 0000 0000', 10.0, 2.5, 0.0, 0.0
; expect: [offset_result] = 9.0, 9.0, X'FFD2 5A82 7999 FCEF', 0.25, 9.0, 9.0
; expect: [short_source] = 2.0, X'FFD2 5A82 7999 FCEF', 0.25
; expect: [short_source + 3*64] = X'7000 0000 0000 0000', 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap SQRTV
; expect: [chain] = 2.25, 1.5, X'FFD2 4E62 3850 2484', X'FFD2 46D3 E067 0BFD'
; expect: [chain + 4*64] = X'FFD2 4353 CBCA 7944', X'FFD2 41A4 8079 9D94'
; expect: [chain + 6*64] = X'FFD2 40D0 EB3E 9314'

        signs   SQRTV
; expect: [negated] = X'7000 0000 0000 0000', X'7000 0000 0000 0000'
; expect: [negated + 2*64] = X'7000 0000 0000 0000', 1.0
; expect: [negated + 4*64] = X'7000 0000 0000 0000', X'7000 0000 0000 0000'
; expect: [magnitudes] = 2.0, X'FFD2 5A82 7999 FCEF', 0.25, 1.0, 10.0, 2.5
; expect: [negative] = X'7000 0000 0000 0000', X'7000 0000 0000 0000'
; expect: [negative + 2*64] = X'7000 0000 0000 0000', X'7000 0000 0000 0000'
; expect: [negative + 4*64] = X'7000 0000 0000 0000', X'7000 0000 0000 0000'

        .data
odd_a:  .word   16, X'0001 0000 0000 0009', 0.0, X'0010 0000 0000 0000'
        .word   X'7000 0000 0000 0000', X'6FFF 7FFF FFFF FFFF'
        .code
        specials SQRTV, 6
; expect: [odd] = X'FFFE 0000 0000 0010', X'FFFF 0000 0000 0008', 0.0, 0.0
; expect: [odd + 4*64] = X'7000 0000 0000 0000', X'37E8 7FFF FFFF FFFF'

        EXIT
; expect-flags: X'0000 0000 0016 0000'
; expect-warning: recurrence
