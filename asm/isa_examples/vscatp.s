        .include "vectors.s"
        .regs   r16, period, column, a
        words   column, 12.0, 22.0
        ELEN    column, 2
        words   a, 11.0, 0, 21.0, 0     ; rows of two
        IX      a, 64                   ; starts at the second column
        ES      period, 2
        VSCATP  period, [column], [a]
        EXIT
; expect: [a.words] = 11.0, 12.0, 21.0, 22.0
