        .include "vectors.s"
        .regs   r16, period, a, column, last, back
        words   a, 11.0, 12.0, 21.0, 22.0 ; rows of two
        words   column
        ELEN    column, 2
        ES      period, 2
        VGATHP  period, [a], [column]
        words   back
        EX      last, a.words + 3*64    ; a negative period goes back
        ES      period, -1
        VGATHP  period, [last], [back]
        .regs   r21, d, e               ; operands of 32 bits
        halves  d, 11.0, 12.0, 21.0, 22.0
        halves  e
        ELEN    e, 2
        ES      period, 2
        VGATHP,H period, [d], [e]
        EXIT
; expect: [column.words] = 11.0, 21.0, 0
; expect: [back.words] = 22.0, 21.0, 12.0, 11.0
; expect-halves: [e.halves] = 11.0, 21.0, 0
