; pixel-by-pixel.s - clean := (raw - dark) gain, a loop over all pixels.

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

        .regs   r10, raw_at, dark_at, gain_at, clean_at
        .regs   r20, i, one, count, x, y, factor

        EX      raw_at, raw
        EX      dark_at, dark
        EX      gain_at, gain
        EX      clean_at, clean
        ES      i, 0
        ES      one, 1
        ES      count, n
next:   LOD     [raw_at, i], x
        LOD     [dark_at, i], y
        LOD     [gain_at, i], factor
        SUBN    x, y, x
        MPYS    x, factor, x
        STO     [clean_at, i], x
        IBXLT   i, one, count, next, i
        EXIT
; expect: [clean] = 5.0, 5.0, 6.0, 6.0, 7.0
