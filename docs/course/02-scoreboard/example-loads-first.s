; example-loads-first.s - the sum of six numbers, all loaded before the first addition.

        .include "print.s"

        .regs   r10, x_at, sum, i1, i2, i3, i4, i5
        .regs   r20, x0, x1, x2, x3, x4, x5
        .regs   r30, left, middle, right

        .data
x:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code

        EX      x_at, x
        ES      i1, 1
        ES      i2, 2
        ES      i3, 3
        ES      i4, 4
        ES      i5, 5

        LOD     [x_at], x0
        LOD     [x_at, i1], x1
        LOD     [x_at, i2], x2
        LOD     [x_at, i3], x3
        LOD     [x_at, i4], x4
        LOD     [x_at, i5], x5
        ADDN    x0, x1, sum
        ADDN    sum, x2, sum
        ADDN    sum, x3, sum
        ADDN    sum, x4, sum
        ADDN    sum, x5, sum

        print_number sum
        newline
        EXIT
; expect-print: 21
