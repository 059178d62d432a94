; row-by-row.s - clean := (raw - dark) gain, each row a vector.

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

        .regs   r10, raws, darks, gains, cleans, i, one, count, step

        descriptor raws, raw, columns
        descriptor darks, dark, columns
        descriptor cleans, clean, columns
        descriptor gains, gain, columns
        ES      i, 0
        ES      one, 1
        ES      count, rows
        EX      step, 64 * columns
next:   SUBNV   [raws], [darks], [cleans]
        MPYSV   [cleans], [gains], [cleans]
        ADDX    raws, step, raws
        ADDX    darks, step, darks
        ADDX    gains, step, gains
        ADDX    cleans, step, cleans
        IBXLT   i, one, count, next, i
        EXIT
; expect: [clean] = 5.0, 5.0, 6.0, 6.0, 7.0
