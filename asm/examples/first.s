; first.s - y := 2 x + y for whole vectors, in two instructions.

        .include "print.s"
        .regs   r16, x, y, two
        .data
        .vector xs, 5, 1.0, 2.0, 3.0, 4.0, 5.0
        .vector ys, 5, 10.0, 10.0, 10.0, 10.0, 10.0
        .code
        descriptor x, xs, 5             ; x describes a vector: its length and
        descriptor y, ys, 5             ; its address in memory
        load_constant two, 2.0
        MPYSV   [x], two, [x]           ; [x] is a vector, two is a number
        ADDNV   [x], [y], [y]
        print_vector y
        newline
        EXIT
; expect: [ys] = 12.0, 14.0, 16.0, 18.0, 20.0
; expect-print: 12 14 16 18 20
