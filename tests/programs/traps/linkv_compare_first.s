; The first makes numbers, not bits.
        .include "bad_link.inc"
        CMPGEV  [va], x, [from]
        ANDV    [from], y, [to]
