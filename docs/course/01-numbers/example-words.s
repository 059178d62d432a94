; example-words.s - numbers, and the words that hold them.

        .include "print.s"

        .macro  show register
        print_hex \register
        print_text "  ", text
        print_number \register
        newline
        .endm

        .regs   r10, x, text

        load_constant x, 1.0
        show    x
        load_constant x, 2.0
        show    x
        load_constant x, 3.0
        show    x
        load_constant x, -3.0
        show    x
        load_constant x, 0.1
        show    x
        ES      x, 3                    ; enter an integer
        show    x
        ES      x, -3
        show    x
        EXIT
; expect-print: FFD2 4000 0000 0000  1
; expect-print: FFD3 4000 0000 0000  2
; expect-print: FFD3 6000 0000 0000  3
; expect-print: FFD3 A000 0000 0000  -3
; expect-print: FFCE 6666 6666 6666  0.1
; expect-print: 0000 0000 0000 0003  3
; expect-print: 0000 FFFF FFFF FFFD  -3
