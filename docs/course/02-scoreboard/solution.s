; solution.s - a polynomial of degree 7 of one number, with few waits.
;
;   p = (a0 + a1 x) + (a2 + a3 x) x^2 + ((a4 + a5 x) + (a6 + a7 x) x^2) x^4
;
; The brackets are independent, so they do not wait for each other.  The highest coefficients
; start the longest chains: they are loaded first.  The registers of the next indices are
; entered between the loads.

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
        ES      i7, 7
        LOD     [a_at, i7], a7
        ES      i6, 6
        LOD     [a_at, i6], a6
        ES      i5, 5
        LOD     [a_at, i5], a5
        ES      i4, 4
        LOD     [a_at, i4], a4
        ES      i3, 3
        LOD     [a_at, i3], a3
        ES      i2, 2
        ES      i1, 1
        EX      p_at, p
        MPYS    x1, x1, x2
        LOD     [a_at, i2], a2
        LOD     [a_at, i1], a1
        MPYS    a7, x1, p67
        LOD     [a_at], a0
        MPYS    a5, x1, p45
        MPYS    x2, x2, x4
        ADDN    a6, p67, p67
        MPYS    a3, x1, p23
        ADDN    a4, p45, p45
        MPYS    p67, x2, p67
        ADDN    p45, p67, p45
        ADDN    a2, p23, p23
        MPYS    a1, x1, p01
        MPYS    p45, x4, p45
        MPYS    p23, x2, p23
        ADDN    a0, p01, p01
        ADDN    p01, p23, p01
        ADDN    p01, p45, p01
        STO     [p_at], p01
        EXIT
; expect: [p] = 255.0
