; example-left.s - how many points are inside after each step, and the picture of those that
; are at the end.

        .include "print.s"
        .include "example-data.inc"

        .regs   r40, left, row, bits, i, rows, text

        VTOV    [cxs], [xs]
        VTOV    [cys], [ys]
next:   MPYSV   [xs], [xs], [xxs]
        MPYSV   [ys], [ys], [yys]
        ADDNV   [xxs], [yys], [sums]
        CMPLTV  [sums], four, [inside]
        CNTOB   [inside], left
        print_integer k
        print_text " ", text
        print_integer left
        newline
        MPYSV   [xs], [ys], [ys]
        SUBNV   [xxs], [yys], [xs]
        ADDNV   [xs], [cxs], [xs]
        LINKV
        MPYSV   [ys], two, [ys]
        ADDNV   [ys], [cys], [ys]
        IBXLE   k, one, last, next, k

        descriptor row, in, 80
        ES      bits, 160               ; every second row
        ES      i, 0
        ES      rows, n / 160
draw:   print_bits row
        newline
        ADDX    row, bits, row
        IBXLT   i, one, rows, draw, i
        EXIT
; expect: left = 910
