; Neighbours do not go element by element.
        .include "bad_link.inc"
        MPYSV   [va], x, [from]
        DELTAV  [from], [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
