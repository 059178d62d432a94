; horner-in-a-loop.s - Horner's rule, an iteration for each coefficient.

        .include "core.s"

        .data
x:      .word   2.0
a:      .word   1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0
p:      .space  1
        .code

        .regs   r10, at, i, one, result, x1, t, last

        EX      at, x
        LOD     [at], x1
        EX      at, a
        ES      i, 7
        ES      one, -1
        ES      last, 0
        RTOR    r0, result
next:   LOD     [at, i], t
        MPYS    result, x1, result
        ADDN    result, t, result
        IBXGE   i, one, last, next, i
        EX      at, p
        STO     [at], result
        EXIT
; expect: [p] = 255.0
