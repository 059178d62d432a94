; start.s - for each point the parabola of its cell, from a table of records.
;
;   y(place(i)) = value + x(i) (slope + x(i) bend)     with the record of cell(i)

        .include "core.s"

        .ifndef n                       ; the tests define it
        .equ    n, 6                    ; points
        .equ    m, 3                    ; cells
        .endif

        .record CELL
        .field  VALUE
        .field  SLOPE
        .field  BEND
        .at     4                       ; words of a record
        .endrecord

        .data
cell:   .rept   n                       ; 1 .. m
        .word   (\+ * 2 + 2) % m + 1
        .endr
x:      .rept   n
        .word   \+ * 0.125
        .endr
place:  .rept   n                       ; 0 .. n - 1, each once
        .word   n - 1 - \+
        .endr
table:  .rept   m
        .word   \+ * 10.0, 4.0, 8.0, 0
        .endr
y:      .space  n

; your code here: vectors for intermediate results
        .code

        .regs   r10, cells, xs, places

        descriptor cells, cell, n
        descriptor xs, x, n
        descriptor places, place, n
; your code here
        EXIT
; expect: [y] = 5.625, 14.0, 22.625, 1.5, 10.625, 20.0
