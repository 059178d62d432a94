; dot.s - the length of a vector: the square root of its dot product with
; itself, computed by DOTV, and by a product and a sum.
;
; DOTV executes two flops per element and takes one element per clock. Its sum,
; like that of SUMV, has two parts, upper and lower, joined by two additions.

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

; 4 clocks for the descriptors; the dot product 116 + 4, and 1,030 for the
; first touch of the data's page; its two additions 10; issue of the root,
; which overlaps the product; 51 + 2 and 96 + 2, 2 of them hidden; two
; additions 10; the rest 7:
; expect-clocks: 1331
; expect-model: cyber205-2pipe-prior
; (its constants are round numbers, the fitted ones are not)
