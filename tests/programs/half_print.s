; What is printed of half words is compared with the lines expected.  A half that is not
; extended first, or the wrong half, makes a line differ.
; Half words printed: extended first, so 0.1 is what it was cut to.

        .include "print.s"
        .include "vectors.s"

        .regs   r16, d, whole, scratch

        load_half h60, 0.1, scratch
        print_half h60, scratch
        newline
        halves  d, 1.5, -2.0, 3.0, 0.5
        words   whole
        print_half_vector d, whole
        newline
        EXIT
; expect-print: 0.099999994039536
; expect-print: 1.5 -2 3 0.5
