; The table lies on words.
        .include "../vector.inc"
        .data
a:      .word   0, 1, 0, 0, 1, 1
        .code
        descriptor va, a, n
        EX      vb, a + 8
        no_result
        VXTOV   [va], [vb], [to]
; expect-trap: misaligned-operand
