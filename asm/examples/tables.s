; tables.s - has data that the assembler computes and data from a file.

        .include "print.s"

        .equ    n, 8
        .equ    pi, 4 * atan2(1, 1)

        .data
sines:
        .rept   n
        .word   sin(2 * pi * \+ / n)
        .endr
places: .incfile "loads.csv", "place", integers
loads:  .incfile "loads.csv", "load"
loads_end:
        .equ    count, (loads_end - loads) / 64
        .vector waves, count
        .code

        .regs   r10, index, load, wave, table

; Multiplies each load by the sine at its position.
        descriptor index, places, count
        descriptor load, loads, count
        descriptor wave, waves, count
        EX      table, sines
        VXTOV   [index], [table], [wave]
        MPYSV   [wave], [load], [wave]
        print_vector_fixed wave, 10, 4, 0, table
        newline
        EXIT
; expect-print:     0.0000    -1.5910     0.0000
; expect: [sines] = 0, 0.7071067811865, 1.0, 0.7071067811865 ~ 1e-12
