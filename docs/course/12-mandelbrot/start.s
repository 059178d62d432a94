; start.s - the number of steps after which points leave the circle of radius 2.
;
;   z(1) = c,  z(k + 1) = z(k)^2 + c;  the count of c: the least k with |z(k)|^2 >= 4

        .include "core.s"

        .ifndef n                       ; the tests define it
        .equ    n, 6                    ; points
        .equ    most, 20                ; steps
        .endif

        .data
cx:     .rept   n                       ; c = cx + i cy
        .word   -2.25 + 0.5 * \+
        .endr
cy:     .rept   n
        .word   0.25
        .endr
counts: .space  n                       ; integers
total:  .space  1                       ; their sum, a number

x:      .space  n
y:      .space  n
xx:     .space  n
yy:     .space  n
        .code

        .regs   r10, cxs, cys, xs, ys, xxs, yys, result
        .regs   r20, two, four, one, k, last, at
        .regs   r36, upper, lower

        descriptor cxs, cx, n
        descriptor cys, cy, n
        descriptor xs, x, n
        descriptor ys, y, n
        descriptor xxs, xx, n
        descriptor yys, yy, n
        descriptor result, counts, n
        load_constant two, 2.0
        load_constant four, 4.0
        ES      one, 1
        ES      k, 1
        ES      last, most

        .kernel iterate
        VTOV    [cxs], [xs]             ; z(1) = c
        VTOV    [cys], [ys]

next:   MPYSV   [xs], [xs], [xxs]
        MPYSV   [ys], [ys], [yys]
; your code here: which points are inside, and their counts

        MPYSV   [xs], [ys], [ys]
        SUBNV   [xxs], [yys], [xs]
        ADDNV   [xs], [cxs], [xs]       ; x x - y y + cx
        LINKV
        MPYSV   [ys], two, [ys]
        ADDNV   [ys], [cys], [ys]       ; 2 x y + cy
        IBXLT   k, one, last, next, k

; your code here: the counts of the remaining points

        SUMV    [result], upper
        join_parts upper, lower, upper
        EX      at, total
        STO     [at], upper
        .endkernel
        EXIT
; expect: [counts] = 1, 4, 9, 13, 20, 20
; expect: [total] = 67.0
