; example-digits.s - an integer has few digits, and so has its product.

        .include "print.s"
        .regs   r10, x, y, product, text

        load_constant x, 3.1416
        ES      y, 5                    ; the integer 5: three significant bits
        MPYS    x, y, product
        print_text "times the integer:   ", text
        print_number product
        newline
        ADDN    y, r0, y                ; the same number, normalised
        MPYS    x, y, product
        print_text "times the number:    ", text
        print_number product
        newline
        EXIT
; expect-print: times the integer:   14
; expect-print: times the number:    15.7079999999999
