; The last element of B lies in a page that is not mapped: nothing is stored.
        .include "../vector.inc"
        .equ    page, 65536 * 64
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        descriptor va, a, n
        descriptor vb, (a / page + 1) * page - 5 * 64, n
        into    nothing
        ADDNV   [va], [vb], [to]
; expect-trap: unmapped-address
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect-flags: 0
