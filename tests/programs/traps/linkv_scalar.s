; A scalar instruction cannot be linked.
        .include "bad_link.inc"
        ADDN    x, y, value
        ADDNV   [va], y, [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
