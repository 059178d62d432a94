; Both instructions have one length.
        .include "bad_link.inc"
        MPYSV   [va], x, [short_a]
        ADDNV   [short_a], [va], [to]
