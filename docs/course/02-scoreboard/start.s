; start.s - a polynomial of degree 7 of one number.

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
        LOD     [a_at, i7], a7

        ; your code here, in place of this line: coefficients, result := p(x)
        ES      result, 0

        EX      p_at, p
        STO     [p_at], result
        EXIT
; expect: [p] = 255.0
