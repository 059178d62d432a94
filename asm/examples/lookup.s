; lookup.s - computes a function by linear interpolation in a table.
;
; The table contains the squares of 0 .. 10. For each argument u
;
;   i = floor(u),  f = u - i,  y = t(i) + f (t(i + 1) - t(i))
;
; FLRV rounds a vector down to integers, which are a list of indices.
; Two gathers load the entries of the table. A scatter stores the
; results in another order.

        .include "core.s"

        .equ    n, 5

        .data
table:  .word   0.0, 1.0, 4.0, 9.0, 16.0, 25.0, 36.0, 49.0, 64.0, 81.0, 100.0
u:      .word   2.5, 0.0, 9.5, 4.25, 7.0
order:  .word   4, 3, 2, 1, 0
index:  .space  n
part:   .space  n
low:    .space  n
high:   .space  n
y:      .space  n
sorted: .space  n
        .code

        .regs   r10, us, is, fs, lows, highs, ys, orders, ss, table0, table1

        descriptor us, u, n
        descriptor is, index, n
        descriptor fs, part, n
        descriptor lows, low, n
        descriptor highs, high, n
        descriptor ys, y, n
        descriptor orders, order, n
        EX      ss, sorted
        EX      table0, table
        EX      table1, table + 64

        .kernel lookup
        FLRV    [us], [is]
        SUBNV   [us], [is], [fs]
        VXTOV   [is], [table0], [lows]
        VXTOV   [is], [table1], [highs]
        SUBNV   [highs], [lows], [highs]
        MPYSV   [fs], [highs], [ys]
        ADDNV   [ys], [lows], [ys]
        VTOVX   [orders], [ys], [ss]
        .endkernel

        EXIT
; expect: [index] = 2, 0.0, 9, 4, 7
; expect: [part] = 0.5, 0.0, 0.5, 0.25, 0.0
; expect: [y] = 6.5, 0.0, 90.5, 18.25, 49.0
; expect: [sorted] = 49.0, 18.25, 90.5, 0.0, 6.5

; The descriptors take 17 clocks, and the first access to the page of the data
; takes 1,030. Five simple instructions take 51 + 3 each, a gather 69 + 5, and
; the scatter 71 + 5. Each start-up hides 3 clocks, or 5 after a gather:
; expect-clocks: 1516
; expect-model: cyber205-2pipe-prior
; This model has round constants; the constants of fitted models are not round.
