; The last element of C lies in a page that is not mapped: nothing is stored.
        .include "../vector.inc"
        .equ    page, 65536 * 64
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        descriptor va, a, n
        descriptor to, (a / page + 1) * page - 5 * 64, n
        ADDNV   [va], [va], [to]
; expect-trap: unmapped-address
; expect: [a + (65536 - 5) * 64] = 0, 0, 0, 0, 0
