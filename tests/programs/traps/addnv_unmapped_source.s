; The last element of B lies in a page that is not mapped: nothing is stored.
        .include "../vector.inc"
        .equ    page, 65536 * 64
        six_words
        descriptor vb, (a / page + 1) * page - 5 * 64, n
        no_result
        ADDNV   [va], [vb], [to]
; expect-trap: unmapped-address
; expect-flags: 0
