; dot.s - the length of a vector: the square root of its dot product with
; itself, and the same from a product and a sum.
;
; DOTV makes two flops for each element at the rate of one.  The sum is in the
; order of the elements in both ways, so both give the same bits.

        .include "print.s"

        .equ    n, 4

        .data
v:      .word   2.0, -4.0, 5.0, 6.0
squares:
        .space  n
        .code

        .regs   r10, vs, ts, dot, sum, size, difference, text

        descriptor vs, v, n
        descriptor ts, squares, n

        .kernel dot
        DOTV    [vs], [vs], dot
        SQRT    dot, size
        .endkernel

        .kernel product_and_sum
        MPYSV   [vs], [vs], [ts]
        SUMV    [ts], sum
        .endkernel

        SUBN    dot, sum, difference
        print_text "length ", text
        print_number size
        newline
        EXIT
; expect: r12 = 81.0
; expect: r13 = 81.0
; expect: r14 = 9.0
; expect: r15 = 0.0
; expect-print: length 9

; 4 clocks for the descriptors; the dot product 116 + 2, and 1,030 for the
; first touch of the data's page; issue of the root, which runs on beneath the
; product; 51 + 2 and 96 + 2, 2 of them hidden; the rest 7:
; expect-clocks: 1309
; expect-model: cyber205-2pipe-prior
; (its constants are round, the fitted ones are not)
