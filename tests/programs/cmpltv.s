; CMPLTV: bit C := A < B

        .include "compare.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, -0.5, -0.25
scalars:
        .word   0.5, 4.5
        .bitvector z, n, "101100"
        .code

        uses    CMPLTV
; two bits more than there are elements: they stay as they were
; expect-bits: [plain] = 11000011
; expect-bits: [broadcast_a] = 100100
; expect-bits: [broadcast_b] = 111010
; expect-bits: [where_ones] = 110011
; expect-bits: [where_zeros] = 111100
; expect-bits: [offset_sources] = 010100
; expect-bits: [offset_result] = 11101111
; expect-bits: [any_bit] = 11111000011
; expect-bits: [short_sources] = 110000
; expect-bits: [nothing] = 111111

        signs   CMPLTV
; expect-bits: [negated] = 100101
; expect-bits: [magnitudes] = 100000
; expect-bits: [negative] = 110101

        .data
odd_a:  .word   2, 0.0, 0.0, X'7000 0000 0000 0000', 1.0, 0.1, 0.0
        .word   X'0000 0000 0000 0006', X'FFFF 0000 0000 0001'
        .word   X'6FFF 7FFF FFFF FFFF'
odd_b:  .word   2.0, X'0010 0000 0000 0000', X'8FFF 1234 5678 9ABC'
        .word   X'7000 0000 0000 0000', X'7000 0000 0000 0000'
        .word   X'FFCE 6666 6666 6667', -1, X'0001 0000 0000 0003', 0
        .word   X'6FFF 8000 0000 0000'
        .code
        specials CMPLTV, 10
; expect-bits: [odd] = 0000010000

        EXIT
; comparisons set no data flags
; expect-flags: X'0000 0000 0000 0000'
