; A transmission is of no unit that can be linked.
        .include "bad_link.inc"
        MPYSV   [va], x, [from]
        VTOV    [from], [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
