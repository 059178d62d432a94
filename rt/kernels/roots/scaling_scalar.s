; scaling_scalar.s - scales one polynomial with coefficients of any size for the
; root solver.  Method and order of the operations are those of
; scaling_vector.s.
;
; In:  c4 .. c0 and bound.
; Out: the same, scaled; x_low, size, far, near; at_zero = 1: 0 is a root above
;      the bound.  Branches to roots_refused if it cannot be scaled.
; Changes e0-e4, top, degree, k, t0-t2.

        .macro  exponent_of c, e
        EXP     \c, \e
        ADDN    \e, r0, \e
        .endm

        .macro  find_top c, e, power
        CFPEQ   \c, r0, find_top\@
        RTOR    \e, top
        RTOR    \power, degree
find_top\@:
        .endm

        .macro  shift_exponent c, e, power
        CFPEQ   \c, r0, shift_exponent\@
        MPYS    k, \power, t0
        ADDN    \e, t0, \e
        SUBN    \e, top, \e
        CFPGE   largest, \e, shift_exponent\@
        RTOR    \e, largest
shift_exponent\@:
        .endm

        .macro  pack_exponent e, coefficient, into
        SUBN    \e, forty_six, t0
        FLR     t0, t0
        PACK    t0, \coefficient, \into
        .endm

        .macro  scale_coefficient c, e
        CFPEQ   \c, r0, scale_coefficient\@
        CFPGE   \e, least_exponent, scale_large\@
        RTOR    zero, \c
        BIM     scale_coefficient\@
scale_large\@:
        pack_exponent \e, \c, \c
scale_coefficient\@:
        .endm

        .macro  scale
        ES      at_zero, 0
        CFPNE   c0, r0, scale_moved
        ES      s0, 4
scale_move:
        RTOR    c1, c0
        RTOR    c2, c1
        RTOR    c3, c2
        RTOR    c4, c3
        RTOR    zero, c4
        CFPNE   c0, r0, scale_has_zero
        IBXNE   s0, index_minus_one, r0, scale_move, s0
        BIM     roots_store             ; all coefficients are zero
scale_has_zero:
        CFPGE   bound, r0, scale_moved
        ES      at_zero, 1
scale_moved:
        exponent_of c0, e0
        exponent_of c1, e1
        exponent_of c2, e2
        exponent_of c3, e3
        exponent_of c4, e4
        RTOR    e0, top
        RTOR    one, degree
        find_top c1, e1, one
        find_top c2, e2, two
        find_top c3, e3, three
        find_top c4, e4, four
        SUBN    e0, top, t0
        DIVS    t0, degree, t0
        FLR     t0, t0
        ADDN    t0, r0, k
        MPYS    k, degree, t0
        ADDN    top, t0, top

        SUBN    e0, top, e0
        RTOR    zero, largest
        CFPGE   largest, e0, scale_first
        RTOR    e0, largest
scale_first:
        shift_exponent c1, e1, one
        shift_exponent c2, e2, two
        shift_exponent c3, e3, three
        shift_exponent c4, e4, four
        CFPLT   most_above, largest, roots_refused
        ABS     k, t0
        ADDN    t0, largest, t0
        CFPLT   most_exponent, t0, roots_refused

        scale_coefficient c0, e0
        scale_coefficient c1, e1
        scale_coefficient c2, e2
        scale_coefficient c3, e3
        scale_coefficient c4, e4

        pack_exponent k, unit, size
        ADDN    largest, two, t1
        pack_exponent t1, unit, far
        SUBN    r0, t1, t1
        pack_exponent t1, unit, near

        RTOR    zero, x_low
        CFPEQ   bound, r0, scale_bounded
        exponent_of bound, t1
        SUBN    t1, k, t1
        CFPGE   most_exponent, t1, scale_below
        RTOR    most_exponent, t1
scale_below:
        SUBN    r0, most_exponent, t2
        CFPGE   t1, t2, scale_above
        RTOR    t2, t1
scale_above:
        FLR     t1, t1
        PACK    t1, bound, x_low
scale_bounded:
        .endm
