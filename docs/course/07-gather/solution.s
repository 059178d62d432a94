; solution.s - for each point the parabola of its cell, from a table of records.
;
;   y(place(i)) = value + x(i) (slope + x(i) bend)     with the record of cell(i)
;
; A record has four words, so four times the cell is an index into the table.  Cells
; are counted from 1, so the table is addressed one record earlier.

        .include "core.s"

        .ifndef n                       ; the tests define it
        .equ    n, 6
        .equ    m, 3
        .endif

        .record CELL
        .field  VALUE
        .field  SLOPE
        .field  BEND
        .at     4                       ; words of a record
        .endrecord

        .data
cell:   .rept   n                       ; 3, 2, 1, 3, 2, 1
        .word   (\+ * 2 + 2) % m + 1
        .endr
x:      .rept   n
        .word   \+ * 0.125
        .endr
place:  .rept   n                       ; 5, 4, .. 0
        .word   n - 1 - \+
        .endr
table:  .rept   m
        .word   \+ * 10.0, 4.0, 8.0, 0
        .endr
y:      .space  n

index:  .space  n
value:  .space  n
slope:  .space  n
part:   .space  n
        .code

        .regs   r10, cells, xs, places, indices, values, slopes, parts
        .regs   r20, value_table, slope_table, bend_table, y_table, two

        descriptor cells, cell, n
        descriptor xs, x, n
        descriptor places, place, n
        descriptor indices, index, n
        descriptor values, value, n
        descriptor slopes, slope, n
        descriptor parts, part, n
        EX      value_table, table + 64 * (VALUE - CELL_SIZE)
        EX      slope_table, table + 64 * (SLOPE - CELL_SIZE)
        EX      bend_table, table + 64 * (BEND - CELL_SIZE)
        EX      y_table, y
        ES      two, 2

        .kernel look_up
        SHIFTV  [cells], two, [indices]
        VXTOV   [indices], [value_table], [values]
        VXTOV   [indices], [slope_table], [slopes]
        VXTOV   [indices], [bend_table], [parts]
        MPYSV   [parts], [xs], [parts]
        ADDNV   [parts], [slopes], [parts]
        MPYSV   [parts], [xs], [parts]
        ADDNV   [parts], [values], [parts]
        VTOVX   [places], [parts], [y_table]
        .endkernel
        EXIT
; expect: [y] = 5.625, 14.0, 22.625, 1.5, 10.625, 20.0
