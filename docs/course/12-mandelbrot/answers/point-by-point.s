; point-by-point.s - the counts of points, in a scalar loop for each point.

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

        .code

        .regs   r10, cxs, cys, result, i, count, one, k, last, four, at
        .regs   r20, a, b, x, y, xx, yy, xy, sum
        .regs   r30, upper, lower

        EX      cxs, cx
        EX      cys, cy
        descriptor result, counts, n
        load_constant four, 4.0
        ES      one, 1
        ES      count, n
        ES      last, most
        ES      i, 0

        .kernel iterate
point:  LOD     [cxs, i], a
        LOD     [cys, i], b
        RTOR    a, x
        RTOR    b, y
        ES      k, 1
next:   MPYS    x, x, xx
        MPYS    y, y, yy
        MPYS    x, y, xy
        ADDN    xx, yy, sum
        SUBN    xx, yy, x
        CFPGE   sum, four, outside
        ADDN    xy, xy, xy
        ADDN    x, a, x
        ADDN    xy, b, y
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
