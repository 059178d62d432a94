; example-upper.s - two differences: normalised and upper.

        .include "print.s"
        .regs   r10, a, b, normal, upper

        load_constant a, 2.0
        load_constant b, 1.5
        SUBN    a, b, normal
        SUBU    a, b, upper
        print_hex normal
        newline
        print_hex upper
        newline
        EXIT
; expect: normal = 0.5
; expect: upper = X'FFD3 1000 0000 0000'
