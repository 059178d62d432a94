; example-loop.s - running sums, one after another.

        .include "example-data.inc"

        .data
x:      .space  n
        .code

        .regs   r10, bs, xs, i, one, count, right, sum

        EX      bs, b
        EX      xs, x
        ES      i, 0
        ES      one, 1
        ES      count, n
        ES      sum, 0
next:   LOD     [bs, i], right
        ADDN    sum, right, sum
        STO     [xs, i], sum
        IBXLT   i, one, count, next, i
        EXIT
; expect: [x + 64 * (n - 1)] = 1000.0
