; all-steps.s - the counts of points: all steps for all points, and a control vector.

        .include "core.s"

        .ifndef n                       ; the tests define it
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
counts: .space  n
total:  .space  1

x:      .space  n
y:      .space  n
xx:     .space  n
yy:     .space  n
sum:    .space  n
        .bitvector in, n
        .code

        .regs   r10, cxs, cys, xs, ys, xxs, yys, sums, result, inside
        .regs   r20, two, four, one, k, last, at
        .regs   r36, upper, lower

        descriptor cxs, cx, n
        descriptor cys, cy, n
        descriptor xs, x, n
        descriptor ys, y, n
        descriptor xxs, xx, n
        descriptor yys, yy, n
        descriptor sums, sum, n
        descriptor inside, in, n
        descriptor result, counts, n
        load_constant two, 2.0
        load_constant four, 4.0
        ES      one, 1
        ES      k, 1
        ES      last, most

        .kernel iterate
        VTOV    one, [result]
        VTOV    [cxs], [xs]
        VTOV    [cys], [ys]

next:   MPYSV   [xs], [xs], [xxs]
        MPYSV   [ys], [ys], [yys]
        ADDNV   [xxs], [yys], [sums]
        CMPLTV  [sums], four, [inside]
        ADDXV   [result], one, [result] ? [inside]
        MPYSV   [xs], [ys], [ys]
        SUBNV   [xxs], [yys], [xs]
        ADDNV   [xs], [cxs], [xs]       ; x x - y y + cx
        LINKV
        MPYSV   [ys], two, [ys]
        ADDNV   [ys], [cys], [ys]       ; 2 x y + cy
        IBXLT   k, one, last, next, k

        SUMV    [result], upper
        join_parts upper, lower, upper
        EX      at, total
        STO     [at], upper
        .endkernel
        EXIT
; expect: [total] = 60471.0
