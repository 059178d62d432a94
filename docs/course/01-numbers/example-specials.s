; example-specials.s - machine zero and indefinite.

        .include "print.s"
        .regs   r10, one, zero, nothing, sum, text

        load_constant one, 1.0
        SUBN    one, one, zero
        DIVS    one, zero, nothing
        ADDN    nothing, one, sum
        print_text "1 - 1:        ", text
        print_hex zero
        newline
        print_text "1 / 0:        ", text
        print_hex nothing
        newline
        print_text "1 / 0 + 1:    ", text
        print_hex sum
        newline
        EXIT
; expect-print: 1 - 1:        8000 0000 0000 0000
; expect-print: 1 / 0:        7000 0000 0000 0000
; expect-print: 1 / 0 + 1:    7000 0000 0000 0000
