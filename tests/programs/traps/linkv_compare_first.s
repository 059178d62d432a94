; The first makes numbers, not bits.
        .include "bad_link.inc"
        CMPGEV  [va], x, [from]
        ANDV    [from], y, [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
