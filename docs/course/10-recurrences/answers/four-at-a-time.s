; four-at-a-time.s - the recurrence as a scalar loop of four steps: loads are early, and a
; branch is taken once for four elements.  Up to three results are stored after x.

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
        .space  3
        .code

        .regs   r10, as, bs, xs, i, i1, i2, i3, four, count, last
        .regs   r20, a0, a1, a2, a3, b0, b1, b2, b3, x0, x1, x2

        EX      as, a
        EX      bs, b
        EX      xs, x
        ES      i, 0
        ES      i1, 1
        ES      i2, 2
        ES      i3, 3
        ES      four, 4
        ES      count, n
        ES      last, 0

        .kernel recurrence
next:   LOD     [as, i], a0
        LOD     [bs, i], b0
        LOD     [as, i1], a1
        LOD     [bs, i1], b1
        LOD     [as, i2], a2
        LOD     [bs, i2], b2
        LOD     [as, i3], a3
        LOD     [bs, i3], b3
        MPYS    a0, last, x0
        ADDN    x0, b0, x0
        MPYS    a1, x0, x1
        ADDN    x1, b1, x1
        MPYS    a2, x1, x2
        ADDN    x2, b2, x2
        MPYS    a3, x2, last
        ADDN    last, b3, last
        STO     [xs, i], x0
        STO     [xs, i1], x1
        STO     [xs, i2], x2
        STO     [xs, i3], last
        ADDX    i1, four, i1
        ADDX    i2, four, i2
        ADDX    i3, four, i3
        IBXLT   i, four, count, next, i
        .endkernel
        EXIT
; expect: [x] = 1.0, 1.0, 1.0 ~ 1e-9
; expect: [x + 64 * (n - 1)] = 1.0 ~ 1e-9
