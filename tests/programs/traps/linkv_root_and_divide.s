; A root and a division are of one unit.
        .include "bad_link.inc"
        SQRTV   [va], [from]
        DIVSV   [from], x, [to]
