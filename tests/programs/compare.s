; The bits that the four comparisons of two vectors yield are compared with the
; relations of their elements: every use, and operands that are not normalised.  A wrong
; relation, a wrong bit address, or a change outside the result makes a bit differ.
; tests: CMPEQV CMPNEV CMPGEV CMPLTV
; warns: zero-length CMPEQV CMPNEV CMPGEV CMPLTV

        .include "compare.inc"

; The bits that the four comparisons yield in a use.
        .macro  compared use, eq, ne, ge, lt
; expect-bits: [CMPEQV.\use] = \eq
; expect-bits: [CMPNEV.\use] = \ne
; expect-bits: [CMPGEV.\use] = \ge
; expect-bits: [CMPLTV.\use] = \lt
        .endm

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, -0.5, -0.25
scalars:
        .word   0.5, 4.5
odd_a:  .word   2, 0.0, 0.0, X'7000 0000 0000 0000', 1.0, 0.1, 0.0
        .word   X'0000 0000 0000 0006', X'FFFF 0000 0000 0001'
        .word   X'6FFF 7FFF FFFF FFFF'
odd_b:  .word   2.0, X'0010 0000 0000 0000', X'8FFF 1234 5678 9ABC'
        .word   X'7000 0000 0000 0000', X'7000 0000 0000 0000'
        .word   X'FFCE 6666 6666 6667', -1, X'0001 0000 0000 0003', 0
        .word   X'6FFF 8000 0000 0000'
        .code
; CMPEQV CMPNEV CMPGEV CMPLTV: bit C := A = B, A is not B, A >= B, A < B
        comparison CMPEQV
        comparison CMPNEV
        comparison CMPGEV
        comparison CMPLTV
; two bits after the last element keep their values
        compared plain,          00011011, 11100111, 00111111, 11000011
        compared broadcast_a,    010000, 101111, 011011, 100100
        compared broadcast_b,    000100, 111011, 000101, 111010
        compared where_ones,     010111, 111011, 011111, 110011
        compared where_zeros,    101110, 111101, 101111, 111100
        compared offset_sources, 000001, 111110, 101011, 010100
        compared offset_result,  11001111, 11111111, 11011111, 11101111
        compared any_bit,        11100011011, 11111100111, 11100111111, 11111000011
        compared short_sources,  000011, 111100, 001111, 110000
        compared nothing,        111111, 111111, 111111, 111111
        compared negated,        001000, 110111, 011010, 100101
        compared magnitudes,     001110, 110001, 011111, 100000
        compared negative,       001010, 110101, 001010, 110101
        compared odd,            1110000100, 0001111011, 1110001111, 0000010000
        EXIT
