; y := 2 x, and the number of elements of y above 1000.

        .include "core.s"
        .warm
        .regs   r16, xs, ys, two, limit, count, place, hits

        .ifndef n
        .equ    n, 5                    ; the tests define it
        .endif

        .data
x:
        .rept   n
        .word   \+ * 1000.0
        .endr
        .vector y, n
        .bitvector bits, n
above:  .word   0
        .code
        descriptor xs, x, n
        descriptor ys, y, n
        load_constant two, 2.0
        ; here
        EXIT
