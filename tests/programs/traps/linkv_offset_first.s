; What is handed over has no offset.
        .include "bad_link.inc"
        MPYSV   [va], x, [from]
        ADDNV   [from, twice], [va], [to]
