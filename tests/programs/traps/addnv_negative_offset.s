; An offset goes forward.
        .include "../vector.inc"
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        descriptor va, a + 64, 4
        EX      once, -1
        into    nothing
        ADDNV   [va, once], [va], [to]
; expect-trap: bad-descriptor
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
