; A transmission is of no unit that can be linked.
        .include "bad_link.inc"
        MPYSV   [va], x, [from]
        VTOV    [from], [to]
