        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, word(12), word(12), word(0), word(-1)
        words   b, word(10), word(3), word(5), word(5)
        words   c
        ANDNV   [a], [b], [c]
        EXIT
; expect: [c.words] = word(4), word(12), word(0), word(~5)
