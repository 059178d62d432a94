; solution.s - the number of steps after which points leave the circle of radius 2.
;
;   z(1) = c,  z(k + 1) = z(k)^2 + c;  the count of c: the least k with |z(k)|^2 >= 4
;
; A point outside stays outside, so it may be kept for some steps: its count does not grow.
; When a quarter of the points are outside, the others are compressed.

        .include "core.s"

        .ifndef n                       ; the tests define it
        .equ    n, 6
        .equ    most, 20
        .endif

        .data
cx:     .rept   n
        .word   -2.25 + 0.5 * \+
        .endr
cy:     .rept   n
        .word   0.25
        .endr
counts: .space  n
total:  .space  1

x:      .space  n
y:      .space  n
xx:     .space  n
yy:     .space  n
sum:    .space  n
place:  .space  n
steps:  .space  n
gone:   .space  n
gone_steps:
        .space  n
        .bitvector in, n
        .code

        .regs   r10, cxs, cys, xs, ys, xxs, yys, sums, places, tally, inside
        .regs   r20, leaving, leaving_tally, result, two, four, one
        .regs   r30, k, last, at_work, left, enough, at
        .regs   r36, upper, lower

; The length of a descriptor, from a register.
        .macro  take_length r, length
        ELEN    \r, 0
        ADDLEN  \r, \length, \r
        .endm

        descriptor cxs, cx, n
        descriptor cys, cy, n
        descriptor xs, x, n
        descriptor ys, y, n
        descriptor xxs, xx, n
        descriptor yys, yy, n
        descriptor sums, sum, n
        descriptor places, place, n
        descriptor tally, steps, n
        descriptor inside, in, n
        descriptor leaving, gone, n
        descriptor leaving_tally, gone_steps, n
        descriptor result, counts, n
        load_constant two, 2.0
        load_constant four, 4.0
        ES      one, 1
        ES      k, 1
        ES      last, most
        ES      at_work, n

        .kernel iterate
        INTVLV  r0, one, [places]       ; 0, 1, 2 ..
        VTOV    one, [tally]
        VTOV    [cxs], [xs]
        VTOV    [cys], [ys]

next:   MPYSV   [xs], [xs], [xxs]
        MPYSV   [ys], [ys], [yys]
        ADDNV   [xxs], [yys], [sums]
        CMPLTV  [sums], four, [inside]
        ADDXV   [tally], one, [tally] ? [inside]
        MPYSV   [xs], [ys], [ys]
        SUBNV   [xxs], [yys], [xs]

        CNTOB   [inside], left
        SHIFTI  at_work, -2, enough
        SUBX    at_work, enough, enough ; three quarters
        IBXGT   left, r0, enough, go_on
        CPSV    [places], [leaving] ?! [inside]
        CPSV    [tally], [leaving_tally] ?! [inside]
        VTOVX   [leaving], [leaving_tally], [result]
        CPSV    [places], [places] ? [inside]
        CPSV    [tally], [tally] ? [inside]
        CPSV    [cxs], [cxs] ? [inside]
        CPSV    [cys], [cys] ? [inside]
        CPSV    [xs], [xs] ? [inside]
        CPSV    [ys], [ys] ? [inside]
        IBXEQ   left, r0, r0, done
        RTOR    left, at_work
        take_length xxs, at_work
        take_length yys, at_work
        take_length sums, at_work
        take_length inside, at_work

go_on:  ADDNV   [xs], [cxs], [xs]       ; x x - y y + cx
        LINKV
        MPYSV   [ys], two, [ys]
        ADDNV   [ys], [cys], [ys]       ; 2 x y + cy
        IBXLT   k, one, last, next, k
        VTOVX   [places], [tally], [result]

done:   SUMV    [result], upper
        join_parts upper, lower, upper
        EX      at, total
        STO     [at], upper
        .endkernel
        EXIT
; expect: [counts] = 1, 4, 9, 13, 20, 20
; expect: [total] = 67.0
