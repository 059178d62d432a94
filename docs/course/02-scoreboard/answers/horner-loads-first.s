; horner-loads-first.s - Horner's rule, all coefficients loaded first.

        .include "core.s"

        .data
x:      .word   2.0
a:      .word   1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0
p:      .space  1
        .code

        .regs   r10, x_at, a_at, p_at
        .regs   r20, i0, i1, i2, i3, i4, i5, i6, i7
        .regs   r30, a0, a1, a2, a3, a4, a5, a6, a7
        .regs   r40, x1, result

        EX      x_at, x
        LOD     [x_at], x1
        EX      a_at, a
        ES      i7, 7
        LOD     [a_at, i7], result
        ES      i6, 6
        LOD     [a_at, i6], a6
        ES      i5, 5
        LOD     [a_at, i5], a5
        ES      i4, 4
        LOD     [a_at, i4], a4
        ES      i3, 3
        LOD     [a_at, i3], a3
        ES      i2, 2
        LOD     [a_at, i2], a2
        ES      i1, 1
        LOD     [a_at, i1], a1
        LOD     [a_at], a0
        MPYS    result, x1, result
        ADDN    result, a6, result
        MPYS    result, x1, result
        ADDN    result, a5, result
        MPYS    result, x1, result
        ADDN    result, a4, result
        MPYS    result, x1, result
        ADDN    result, a3, result
        MPYS    result, x1, result
        ADDN    result, a2, result
        MPYS    result, x1, result
        ADDN    result, a1, result
        MPYS    result, x1, result
        ADDN    result, a0, result
        EX      p_at, p
        STO     [p_at], result
        EXIT
; expect: [p] = 255.0
