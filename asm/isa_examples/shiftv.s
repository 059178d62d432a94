        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1, 1, 8, word(1 << 63)
        words   b, 4, 63, -1, -3
        words   c
        SHIFTV  [a], [b], [c]
        EXIT
; expect: [c.words] = 16, X'8000 0000 0000 0000', 4, X'F000 0000 0000 0000'
