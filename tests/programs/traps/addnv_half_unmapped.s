; The fifth half word would lie in a page that does not exist.
        .include "../half_vector.inc"
        .data
        .org    0xBFFF80
a:      .halfword 1.0, 2.0, 3.0, 4.0
        .code
        descriptor va, a, n
        descriptor to, a, n
        ADDNV,H [va], [va], [to]
; expect-trap: unmapped-address
; expect-halves: [a] = 1.0, 2.0, 3.0, 4.0
; expect-warning: past-storage
