; solution.s - clean := (raw - dark) gain, for all pixels of a picture.
;
; Each row follows the previous one without a gap, so the whole picture is one vector.

        .include "core.s"

        .ifndef rows
        .equ    rows, 3                 ; the tests define it
        .endif
        .ifndef columns
        .equ    columns, 4
        .endif

        .equ    n, rows * columns

        .data
raw:
        .rept   n
        .word   10.0 + float(\+)
        .endr
dark:
        .rept   n
        .word   float(\+ % 2)
        .endr
gain:
        .rept   n
        .word   0.5
        .endr
clean:  .space  n
        .code

        .regs   r10, raws, darks, gains, cleans

        descriptor raws, raw, n
        descriptor darks, dark, n
        descriptor cleans, clean, n
        descriptor gains, gain, n
        SUBNV   [raws], [darks], [cleans]
        MPYSV   [cleans], [gains], [cleans]
        EXIT
; expect: [clean] = 5.0, 5.0, 6.0, 6.0, 7.0
