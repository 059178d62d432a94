; The printed half words are compared with the expected lines.  A half word that is not
; extended first, or the wrong half of a register, makes a line differ.
; Half words are extended before they are printed, so 0.1 shows its truncation.

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
