; Elements of 64 bits lie on words.
        .include "../vector.inc"
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0
        .code
        descriptor va, a + 32, n
        no_result
        ADDNV   [va], [va], [to]
; expect-trap: misaligned-operand
