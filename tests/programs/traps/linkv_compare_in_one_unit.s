; An addition and a comparison are of one unit.
        .include "bad_link.inc"
        SUBNV   [va], x, [from]
        CMPGEV  [from], y, [to]
