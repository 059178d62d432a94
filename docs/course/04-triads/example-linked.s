; example-linked.s - y := 2 x + y, in one stream.

        .include "core.s"

        .ifndef n
        .equ    n, 100
        .endif

        .data
x:
        .rept   n
        .word   float(\+)
        .endr
y:
        .rept   n
        .word   1.0
        .endr
        .code

        .regs   r10, xs, ys, ts, two

        load_constant two, 2.0
        descriptor xs, x, n
        descriptor ys, y, n
        descriptor ts, y, n             ; only a name, as long as the result
        LINKV
        MPYSV   [xs], two, [ts]
        ADDNV   [ts], [ys], [ys]
        EXIT
; expect: [y] = 1.0, 3.0, 5.0
