        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, word(4 << 48 | 0x800000), 5, 1, -1
        words   b, 64, 2, -1, 2
        words   c
        ADDXV   [a], [b], [c]
        EXIT
; expect: [c.words] = word(4 << 48 | 0x800040), 7, 0, 1
