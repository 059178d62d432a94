; start.s - the nearer root of many quadratic equations, t = (b - sqrt(d)) / a, where there is one.

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
few_d:  .space  n                       ; room for those with a root
        .bitvector real, n
        .code

        .regs   r10, as, bs, ds, ts, reals, address, count, miss
        .regs   r20, fds

        load_constant miss, -1.0
        descriptor as, a, n
        descriptor bs, b, n
        descriptor ds, d, n
        descriptor ts, t, n
        descriptor reals, real, n
        descriptor fds, few_d, n

        CMPGEV  [ds], r0, [reals]

        ; your code here, in place of this line
        ES      count, 0

        EX      address, hits
        STO     [address], count
        EXIT
; expect: [t] = -1.0, -1.0, 5.0, 4.0
; expect: [hits] = 4
