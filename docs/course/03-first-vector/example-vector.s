; example-vector.s - c := a + b, two vectors, in one instruction.

        .include "core.s"

        .ifndef n
        .equ    n, 100
        .endif

        .data
a:
        .rept   n
        .word   float(\+)               ; 0.0, 1.0, 2.0 ..
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
        EXIT
; expect: [c] = 1.0, 1.5
