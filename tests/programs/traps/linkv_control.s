; The first instruction has no control vector.
        .include "bad_link.inc"
        MPYSV   [va], x, [from] ? [vz]
        ADDNV   [from], [va], [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
