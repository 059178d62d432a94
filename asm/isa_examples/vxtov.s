        .include "vectors.s"
        .regs   r16, list, table, c
        words   list, 3, 0, 0, 2
        words   table, 10.0, 11.0, 12.0, 13.0
        words   c
        VXTOV   [list], [table], [c]
        .regs   r19, d, e               ; 32 bits, except the list
        halves  d, 10.0, 11.0, 12.0, 13.0
        halves  e
        VXTOV,H [list], [d], [e]
        EXIT
; expect: [c.words] = 13.0, 10.0, 10.0, 12.0
; expect-halves: [e.halves] = 13.0, 10.0, 10.0, 12.0
