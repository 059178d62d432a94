        .include "vectors.s"
        .regs   r16, list, b, table
        words   list, 0, 2, 3, 0
        words   b, 20.0, 22.0, 23.0, 21.0
        words   table
        VTOVX   [list], [b], [table]    ; 21 overwrites 20
        EXIT
; expect: [table.words] = 21.0, 0, 22.0, 23.0
