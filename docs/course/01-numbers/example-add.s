; example-add.s - a first program: 2 + 0.5.

        .include "print.s"
        .regs   r10, a, b, sum

        load_constant a, 2.0
        load_constant b, 0.5
        ADDN    a, b, sum
        print_number sum
        newline
        EXIT
; expect-print: 2.5
