; A sum does not go element by element.
        .include "bad_link.inc"
        MPYSV   [va], x, [from]
        SUMV    [from], value
