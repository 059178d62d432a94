; What is contracted lies on words.
        .include "../half_vector.inc"
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        descriptor va, a + 32, n
        into    nothing
        CONV    [va], [to]
; expect-trap: misaligned-operand
; expect-halves: [nothing] = kept, kept, kept, kept, kept
