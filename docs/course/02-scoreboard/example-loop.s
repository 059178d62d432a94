; example-loop.s - a sum in a loop.

        .include "print.s"

        .equ    n, 100

        .data
x:
        .rept   n
        .word   1.0 / float(\+ + 1)
        .endr
        .code

        .regs   r10, x_at, i, one, count, sum, term

        EX      x_at, x
        ES      i, 0
        ES      one, 1
        ES      count, n
        RTOR    r0, sum
next:   LOD     [x_at, i], term
        ADDN    sum, term, sum
        IBXLT   i, one, count, next, i
        print_number sum
        newline
        EXIT
; expect-print: 5.18737751763763
