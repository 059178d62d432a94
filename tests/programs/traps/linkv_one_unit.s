; The two are of different units.
        .include "bad_link.inc"
        ADDNV   [va], x, [from]
        SUBNV   [from], [va], [to]
