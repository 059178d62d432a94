; brackets-in-order.s - four independent brackets, but loads in the order of the coefficients.

        .include "core.s"

        .data
x:      .word   2.0
a:      .word   1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0
p:      .space  1
        .code

        .regs   r10, x_at, a_at, p_at
        .regs   r20, i0, i1, i2, i3, i4, i5, i6, i7
        .regs   r30, a0, a1, a2, a3, a4, a5, a6, a7
        .regs   r40, x1, x2, x4
        .regs   r50, p01, p23, p45, p67

        EX      x_at, x
        LOD     [x_at], x1
        EX      a_at, a
        LOD     [a_at], a0
        ES      i1, 1
        LOD     [a_at, i1], a1
        ES      i2, 2
        LOD     [a_at, i2], a2
        ES      i3, 3
        LOD     [a_at, i3], a3
        ES      i4, 4
        LOD     [a_at, i4], a4
        ES      i5, 5
        LOD     [a_at, i5], a5
        ES      i6, 6
        LOD     [a_at, i6], a6
        ES      i7, 7
        LOD     [a_at, i7], a7
        MPYS    x1, x1, x2
        MPYS    a1, x1, p01
        MPYS    a3, x1, p23
        MPYS    a5, x1, p45
        MPYS    a7, x1, p67
        MPYS    x2, x2, x4
        ADDN    p01, a0, p01
        ADDN    p23, a2, p23
        ADDN    p45, a4, p45
        ADDN    p67, a6, p67
        MPYS    p23, x2, p23
        MPYS    p67, x2, p67
        ADDN    p01, p23, p01
        ADDN    p45, p67, p45
        MPYS    p45, x4, p45
        ADDN    p01, p45, p01
        EX      p_at, p
        STO     [p_at], p01
        EXIT
; expect: [p] = 255.0
