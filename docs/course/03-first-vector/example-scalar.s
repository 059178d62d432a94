; example-scalar.s - c := a + b, in a loop.

        .include "core.s"

        .ifndef n
        .equ    n, 100
        .endif

        .data
a:
        .rept   n
        .word   float(\+)
        .endr
b:
        .rept   n
        .word   1.0 / float(\+ + 1)
        .endr
c:      .space  n
        .code

        .regs   r10, a_at, b_at, c_at, i, one, count, x, y, sum

        EX      a_at, a
        EX      b_at, b
        EX      c_at, c
        ES      i, 0
        ES      one, 1
        ES      count, n
next:   LOD     [a_at, i], x
        LOD     [b_at, i], y
        ADDN    x, y, sum
        STO     [c_at, i], sum
        IBXLT   i, one, count, next, i
        EXIT
; expect: [c] = 1.0, 1.5
