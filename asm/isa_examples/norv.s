        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, word(12), word(12), word(0), word(-1)
        words   b, word(10), word(3), word(5), word(5)
        words   c
        NORV    [a], [b], [c]
        EXIT
; expect: [c.words] = word(~14), word(~15), word(~5), word(0)
