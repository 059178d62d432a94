; example-two.s - two vector instructions, one after the other: c := (a + b) b.

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

        .regs   r10, as, bs, cs

        descriptor as, a, n
        descriptor bs, b, n
        descriptor cs, c, n
        ADDNV   [as], [bs], [cs]
        MPYSV   [cs], [bs], [cs]
        EXIT
; expect: [c] = 1.0, 0.75
