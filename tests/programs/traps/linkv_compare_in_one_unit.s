; An addition and a comparison are of one unit.
        .include "bad_link.inc"
        SUBNV   [va], x, [from]
        CMPGEV  [from], y, [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
