; What is handed over has no offset.
        .include "bad_link.inc"
        MPYSV   [va], x, [from]
        ADDNV   [va], [from, twice], [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
