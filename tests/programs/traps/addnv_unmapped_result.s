; The last element of C lies in a page that is not mapped: nothing is stored.
        .include "../vector.inc"
        .equ    page, 65536 * 64
        six_words
        descriptor to, (a / page + 1) * page - 5 * 64, n
        ADDNV   [va], [va], [to]
; expect-trap: unmapped-address
; expect: [(a / page + 1) * page - 5 * 64] = 0, 0, 0, 0, 0
