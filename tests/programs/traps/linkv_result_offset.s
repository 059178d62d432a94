; The first has no offset of its result.
        .include "bad_link.inc"
        MPYSV   [va], x, [to, by]
        ADDNV   [to], y, [from]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
