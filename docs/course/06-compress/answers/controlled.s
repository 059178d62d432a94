; controlled.s - the nearer root of many quadratic equations under a control vector.

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
        .bitvector real, n
        .code

        .regs   r10, as, bs, ds, ts, reals, address, count, miss

        load_constant miss, -1.0
        descriptor as, a, n
        descriptor bs, b, n
        descriptor ds, d, n
        descriptor ts, t, n
        descriptor reals, real, n
        CMPGEV  [ds], r0, [reals]
        CNTOB   [reals], count
        SQRTV   [ds], [ts] ? [reals]
        SUBNV   [bs], [ts], [ts] ? [reals]
        DIVSV   [ts], [as], [ts] ? [reals]
        VTOV    miss, [ts] ?! [reals]
        EX      address, hits
        STO     [address], count
        EXIT
; expect: [t] = -1.0, -1.0, 5.0, 4.0
; expect: [hits] = 4
