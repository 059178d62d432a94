; The second instruction does not read what the first one makes.
        .include "bad_link.inc"
        MPYSV   [va], x, [from]
        ADDNV   [va], y, [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
