; The control vector lies in page 0.
        .include "../vector.inc"
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        descriptor va, a, n
        descriptor vz, 64, n
        into    nothing
        ADDNV   [va], [va], [to] ? [vz]
; expect-trap: unmapped-address
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
