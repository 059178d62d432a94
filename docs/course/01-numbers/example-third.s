; example-third.s - three times a third is not one.

        .include "print.s"
        .regs   r10, one, three, third, all

        load_constant one, 1.0
        load_constant three, 3.0
        DIVS    one, three, third
        MPYS    third, three, all
        print_number third
        newline
        print_number all
        newline
        print_hex all
        newline
        EXIT
; expect-print: 0.333333333333333
; expect-print: 0.999999999999993
; expect-print: FFD1 7FFF FFFF FFFF
