; The control vector of a compress may not be left out.
        .include "../vector.inc"
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        descriptor va, a, n
        into    nothing
        .half   X'BC00 0014', X'0000 0012' ; CPSV [va], [to] ? [r0]
; expect-trap: bad-descriptor
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
