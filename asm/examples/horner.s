; horner.s - computes a polynomial for many arguments by Horner's rule.
;
;   p(x) = 2 x^3 - 3 x^2 + 5 = ((2 x - 3) x + 0) x + 5
;
; Each step is a linked pair: a product with x, and a sum with a broadcast
; coefficient. It is one stream with two flops per element.

        .include "core.s"

        .equ    n, 6

        .data
x:      .word   0.0, 1.0, -1.0, 2.0, 0.5, 10.0
p:      .space  n
        .code

        .regs   r10, xs, ps, link
        .regs   r20, a3, a2, a1, a0

        descriptor xs, x, n
        descriptor ps, p, n
        descriptor link, p, n
        load_constant a3, 2.0
        load_constant a2, -3.0
        load_constant a1, 0.0
        load_constant a0, 5.0

        .macro  step first, coefficient
        LINKV
        MPYSV   \first, [xs], [link]
        ADDNV   [link], \coefficient, [ps]
        .endm

        .kernel horner
        step    a3, a2
        step    [ps], a1
        step    [ps], a0
        .endkernel

        EXIT
; expect: [p] = 5.0, 4.0, 0.0, 9.0, 4.5, 1705.0

; Descriptors and constants take 14 clocks, the first access to the page of the
; data 1,030, and three pairs 84 + 3 each. The last two hide 3 clocks each:
; expect-clocks: 1299
; expect-model: cyber205-2pipe-prior
; This model has round constants; the constants of fitted models are not round.
