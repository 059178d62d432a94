; example-loop.s - point after point, each until it has left.

        .include "example-data.inc"

        .regs   r40, i, count, a, b, zx, zy, square_x, square_y, distance, product

        ES      count, n
        ES      i, 0

        .kernel iterate
point:  LOD     [cxs, i], a
        LOD     [cys, i], b
        RTOR    a, zx
        RTOR    b, zy
        ES      k, 1
next:   MPYS    zx, zx, square_x
        MPYS    zy, zy, square_y
        MPYS    zx, zy, product
        ADDN    square_x, square_y, distance
        SUBN    square_x, square_y, zx
        CFPGE   distance, four, outside
        ADDN    product, product, product
        ADDN    zx, a, zx
        ADDN    product, b, zy
        IBXLT   k, one, last, next, k
outside:
        STO     [result, i], k
        IBXLT   i, one, count, point, i

        SUMV    [result], upper
        join_parts upper, lower, upper
        EX      at, total
        STO     [at], upper
        .endkernel
        EXIT
; expect: [total] = 60471.0
