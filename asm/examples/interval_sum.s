; interval_sum.s - computes the integral of 4 / (1 + x x) from 0 to 1, which is
; pi, by the midpoint rule with 1,000 strips.
;
; INTVLV generates the midpoints. SUMV computes the sum in two parts. The
; program has no loop.

        .include "print.s"

        .equ    n, 1000

        .data
x:      .space  n
f:      .space  n
        .code

        .regs   r10, xs, fs, width, middle, one, four, pi, lower, text

        descriptor xs, x, n
        descriptor fs, f, n
        load_constant width, 0.001
        load_constant middle, 0.0005
        load_constant one, 1.0
        load_constant four, 4.0

        .kernel integrate
        INTVLV  middle, width, [xs]
        MPYSV   [xs], [xs], [fs]
        ADDNV   [fs], one, [fs]
        DIVSV   four, [fs], [fs]
        SUMV    [fs], pi
        join_parts pi, lower, pi
        MPYS    pi, width, pi
        .endkernel

        print_text "pi is about ", text
        print_number pi
        newline
        EXIT
; expect: pi = X'FFD3 6487 ED7D CE2F'
; expect-print: pi is about 3.14159273692483

; Descriptors and constants take 12 clocks, the first access to the page of the
; data 1,030, and the vectors 3 x 551, 80 + 1,625 and 96 + 500, of which 4 x 10
; hide. Two additions take 10, the product 5, and other instructions 3:
; expect-clocks: 4974
; expect-model: cyber205-2pipe-prior
; This model has round constants; the constants of fitted models are not round.
