; compressed-unlinked.s - the nearer root of many quadratic equations, compressed and not linked.

        .include "core.s"

        .ifndef n
        .equ    n, 6                    ; the tests define it
        .endif

        .data
a:
        .rept   n
        .word   2.0
        .endr
b:
        .rept   n
        .word   10.0
        .endr
d:
        .rept   n
        .word   4.0 * (float(\+) - 2.0)
        .endr
t:      .space  n
hits:   .space  1                       ; an integer
few_a:  .space  n
few_b:  .space  n
few_d:  .space  n
        .bitvector real, n
        .code

        .regs   r10, as, bs, ds, ts, reals, address, count, miss
        .regs   r20, fas, fbs, fds

        load_constant miss, -1.0
        descriptor as, a, n
        descriptor bs, b, n
        descriptor ds, d, n
        descriptor ts, t, n
        descriptor reals, real, n
        descriptor fas, few_a, n
        descriptor fbs, few_b, n
        descriptor fds, few_d, n
        CMPGEV  [ds], r0, [reals]
        CPSV    [as], [fas] ? [reals]
        CPSV    [bs], [fbs] ? [reals]
        CPSV    [ds], [fds] ? [reals]
        LTOR    fds, count
        SQRTV   [fds], [fds]
        SUBNV   [fbs], [fds], [fds]
        DIVSV   [fds], [fas], [fds]
        MRGV    [fds], miss, [ts] ? [reals]
        EX      address, hits
        STO     [address], count
        EXIT
; expect: [t] = -1.0, -1.0, 5.0, 4.0
; expect: [hits] = 4
