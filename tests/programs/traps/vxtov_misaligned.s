; The table lies on words.
        .include "../vector.inc"
        .data
a:      .word   0, 1, 0, 0, 1, 1
        .code
        descriptor va, a, n
        EX      vb, a + 8
        into    nothing
        VXTOV   [va], [vb], [to]
; expect-trap: misaligned-operand
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
