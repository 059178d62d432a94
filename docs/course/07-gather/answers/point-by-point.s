; point-by-point.s - the parabola of each cell, in a scalar loop.

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

        .code

        .regs   r10, cells, xs, places, value_table, slope_table, bend_table, y_table
        .regs   r20, i, one, count, index, place_of, at, value, slope, part

        EX      cells, cell
        EX      xs, x
        EX      places, place
        EX      value_table, table + 64 * (VALUE - CELL_SIZE)
        EX      slope_table, table + 64 * (SLOPE - CELL_SIZE)
        EX      bend_table, table + 64 * (BEND - CELL_SIZE)
        EX      y_table, y
        ES      i, 0
        ES      one, 1
        ES      count, n

        .kernel look_up
next:   LOD     [cells, i], index
        LOD     [xs, i], at
        LOD     [places, i], place_of
        SHIFTI  index, 2, index
        LOD     [bend_table, index], part
        LOD     [slope_table, index], slope
        LOD     [value_table, index], value
        MPYS    part, at, part
        ADDN    part, slope, part
        MPYS    part, at, part
        ADDN    part, value, part
        STO     [y_table, place_of], part
        IBXLT   i, one, count, next, i
        .endkernel
        EXIT
; expect: [y] = 5.625, 14.0, 22.625, 1.5, 10.625, 20.0
