; example-left.s - the number of points inside after each step, and a picture of those that are
; inside at the end.

        .include "print.s"

        .ifndef n
        .equ    n, 4000
        .equ    most, 50
        .endif

        .data
cx:     .rept   n                       ; rows of 80 points
        .word   float(\+ % 80) * 0.0375 - 2.2
        .endr
cy:     .rept   n
        .word   float(\+ / 80) * 0.047 - 1.17
        .endr

x:      .space  n
y:      .space  n
xx:     .space  n
yy:     .space  n
sum:    .space  n
        .bitvector in, n
        .code

        .regs   r10, cxs, cys, xs, ys, xxs, yys, sums, inside
        .regs   r20, two, four, one, k, last

        descriptor cxs, cx, n
        descriptor cys, cy, n
        descriptor xs, x, n
        descriptor ys, y, n
        descriptor xxs, xx, n
        descriptor yys, yy, n
        descriptor sums, sum, n
        descriptor inside, in, n
        load_constant two, 2.0
        load_constant four, 4.0
        ES      one, 1
        ES      k, 1
        ES      last, most

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
