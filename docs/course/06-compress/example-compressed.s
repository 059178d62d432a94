; example-compressed.s - roots of the positive numbers, compressed.

        .include "core.s"

        .ifndef n
        .equ    n, 4000
        .endif
        .ifndef m                       ; m of them are positive
        .equ    m, 400
        .endif

        .data
x:
        .rept   n
        .if     \+ * m % n < m
        .word   float(\+ + 1)
        .else
        .word   -1.0
        .endif
        .endr
y:      .space  n

few:    .space  n
        .bitvector z, n
        .code

        .regs   r10, xs, fews, ys, zs

        descriptor xs, x, n
        descriptor fews, few, n
        descriptor ys, y, n
        descriptor zs, z, n
        CMPGEV  [xs], r0, [zs]
        CPSV    [xs], [fews] ? [zs]
        SQRTV   [fews], [fews]
        MRGV    [fews], r0, [ys] ? [zs]
        EXIT
; expect: [y] = 1.0
