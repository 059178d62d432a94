; dot.s - computes the length of a vector, the square root of its dot product
; with itself. It uses DOTV, and for comparison a product and a sum.
;
; DOTV executes two flops per element and takes one element per clock. Its sum
; has an upper and a lower part, as in SUMV. Two additions join them.

        .include "print.s"

        .equ    n, 4

        .data
v:      .word   2.0, -4.0, 5.0, 6.0
squares:
        .space  n
        .code

        .regs   r10, vs, ts, dot, dot_low, sum, sum_low, size, difference, text

        descriptor vs, v, n
        descriptor ts, squares, n

        .kernel dot
        DOTV    [vs], [vs], dot
        join_parts dot, dot_low, dot
        SQRT    dot, size
        .endkernel

        .kernel product_and_sum
        MPYSV   [vs], [vs], [ts]
        SUMV    [ts], sum
        join_parts sum, sum_low, sum
        .endkernel

        SUBN    dot, sum, difference
        print_text "length ", text
        print_number size
        newline
        EXIT
; expect: dot = 81.0
; expect: sum = 81.0
; expect: size = 9.0
; expect: difference = 0.0
; expect-print: length 9

; The descriptors take 4 clocks, the dot product 116 + 4, the first access to
; the page of the data 1,030, and two additions 10. The root overlaps the
; product. Product and sum take 51 + 2 and 96 + 2, of which 2 are hidden. Two
; additions take 10, and the other instructions take 7:
; expect-clocks: 1331
; expect-model: cyber205-2pipe-prior
; This model has round constants; the constants of fitted models are not round.
