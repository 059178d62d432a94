; A root and a division are of one unit.
        .include "bad_link.inc"
        SQRTV   [va], [from]
        DIVSV   [from], x, [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
