; Memory has two read paths: of three other sources one is broadcast.
        .include "bad_link.inc"
        MPYSV   [va], [va], [from]
        ADDNV   [from], [va], [to]
