; A sum does not go element by element.
        .include "bad_link.inc"
        MPYSV   [va], x, [from]
        SUMV    [from], value
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
