; doubling.s - the recurrence by doubling: after the pass with distance s each equation has
; the unknown 2 s places before it.  Two pairs of vectors alternate; zeros before them stand
; for missing elements.

        .include "core.s"

        .ifndef n                       ; the tests define it
        .equ    n, 100
        .endif

        .data
a:      .rept   n
        .word   float(\+ % 5) / 8
        .endr
b:      .rept   n
        .word   1.0 - float(\+ % 5) / 8
        .endr
x:      .space  n

        .space  n
a0:     .space  n
        .space  n
b0:     .space  n
        .space  n
a1:     .space  n
        .space  n
b1:     .space  n
product:
        .space  n
        .code

        .regs   r10, as, bs, a_to, b_to, a_before, b_before, products, xs
        .regs   r20, distance, limit, other

        descriptor as, a, n
        descriptor bs, b, n
        descriptor a_to, a0, n
        descriptor b_to, b0, n
        descriptor products, product, n
        descriptor xs, x, n
        EX      distance, 64
        EX      limit, 64 * n

        .kernel recurrence
        VTOV    [as], [a_to]
        VTOV    [bs], [b_to]
        RTOR    a_to, as
        RTOR    b_to, bs
        descriptor a_to, a1, n
        descriptor b_to, b1, n
        IBXGE   distance, r0, limit, done
next:   SUBX    as, distance, a_before
        SUBX    bs, distance, b_before
        MPYSV   [as], [b_before], [products]
        ADDNV   [products], [bs], [b_to]
        MPYSV   [as], [a_before], [a_to]
        RTOR    as, other
        RTOR    a_to, as
        RTOR    other, a_to
        RTOR    bs, other
        RTOR    b_to, bs
        RTOR    other, b_to
        IBXLT   distance, distance, limit, next, distance
done:   VTOV    [bs], [xs]
        .endkernel
        EXIT
; expect: [x] = 1.0, 1.0, 1.0 ~ 1e-9
; expect: [x + 64 * (n - 1)] = 1.0 ~ 1e-9
