; The first has no offset of its result.
        .include "bad_link.inc"
        MPYSV   [va], x, [to, by]
        ADDNV   [to], y, [from]
