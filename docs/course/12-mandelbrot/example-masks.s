; example-masks.s - all points go through all steps, and a control vector counts.

        .include "example-data.inc"

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
