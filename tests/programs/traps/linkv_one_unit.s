; The two are of different units.
        .include "bad_link.inc"
        ADDNV   [va], x, [from]
        SUBNV   [from], [va], [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
