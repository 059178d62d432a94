; Both instructions have one length.
        .include "bad_link.inc"
        MPYSV   [va], x, [short_a]
        ADDNV   [short_a], [va], [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
