; Results of 32 bits lie on half words.
        .include "../half_vector.inc"
        .data
a:      .halfword 1.0, 2.0, 3.0, 4.0, 5.0
        .code
        descriptor va, a, n
        into    nothing
        IX      to, 8
        ADDNV,H [va], [va], [to]
; expect-trap: misaligned-operand
; expect-halves: [nothing] = kept, kept, kept, kept, kept
; expect-warning: past-storage
