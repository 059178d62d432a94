; A transmission is of no unit that can be linked.
        .include "bad_link.inc"
        PACKV   [va], x, [from]
        ADDNV   [from], y, [to]
