; A table of half words lies on half words.
        .include "../half_vector.inc"
        .data
list:   .word   0, 1, 0, 0, 1
table:  .halfword 1.0, 2.0
        .code
        descriptor va, list, n
        EX      vb, table + 8
        into    nothing
        VXTOV,H [va], [vb], [to]
; expect-trap: misaligned-operand
; expect-halves: [nothing] = kept, kept, kept, kept, kept
