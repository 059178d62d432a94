; one-after-another.s - the recurrence as a scalar loop.

        .include "core.s"

        .ifndef n                       ; the tests define it
        .equ    n, 100
        .endif

        .data
a:      .rept   n
        .word   float(\+ % 5) / 8
        .endr
b:      .rept   n
        .word   1.0 - float(\+ % 5) / 8
        .endr
x:      .space  n
        .code

        .regs   r10, as, bs, xs, i, one, count, left, right, last

        EX      as, a
        EX      bs, b
        EX      xs, x
        ES      one, 1
        ES      count, n
        ES      i, 0
        ES      last, 0

        .kernel recurrence
next:   LOD     [as, i], left
        LOD     [bs, i], right
        MPYS    left, last, last
        ADDN    last, right, last
        STO     [xs, i], last
        IBXLT   i, one, count, next, i
        .endkernel
        EXIT
; expect: [x] = 1.0, 1.0, 1.0 ~ 1e-9
; expect: [x + 64 * (n - 1)] = 1.0 ~ 1e-9
