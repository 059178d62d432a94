; A scalar instruction cannot be linked.
        .include "bad_link.inc"
        ADDN    x, y, value
        ADDNV   [va], y, [to]
