; What is extended goes to words.
        .include "../half_vector.inc"
        .data
a:      .halfword 1.0, 2.0, 3.0, 4.0, 5.0
        .code
        descriptor va, a + 32, 4
        into_words nothing
        IX      to, 32
        EXTV    [va], [to]
; expect-trap: misaligned-operand
; expect: [nothing] = kept, kept, kept, kept, kept
; expect-warning: past-storage
