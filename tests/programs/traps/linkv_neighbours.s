; Neighbours do not go element by element.
        .include "bad_link.inc"
        MPYSV   [va], x, [from]
        DELTAV  [from], [to]
