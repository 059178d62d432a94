; An offset goes forward.
        .include "../vector.inc"
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        descriptor va, a + 64, 4
        EX      once, -1
        no_result
        ADDNV   [va, once], [va], [to]
; expect-trap: bad-descriptor
