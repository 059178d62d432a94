; operations_scalar.s - the operations of emission, on one point.
;
; operations_vector.s defines them.

        .regs   r191, each_first, each_second, each_third

        .macro  each_times a, b, c
        MPYS    \a, \b, \c
        .endm

        .macro  each_scale a, k, c
        MPYS    \a, \k, \c
        .endm

        .macro  each_plus a, b, c
        ADDN    \a, \b, \c
        .endm

        .macro  each_shift a, k, c
        ADDN    \a, \k, \c
        .endm

        .macro  each_minus a, b, c
        SUBN    \a, \b, \c
        .endm

        .macro  each_from k, a, c
        SUBN    \k, \a, \c
        .endm

        .macro  each_over a, b, c
        DIVS    \a, \b, \c
        .endm

        .macro  each_reciprocal a, c
        DIVS    each_one, \a, \c
        .endm

        .macro  each_root a, c
        SQRT    \a, \c
        .endm

        .macro  each_copy a, c
        RTOR    \a, \c
        .endm

        .macro  each_same k, c
        RTOR    \k, \c
        .endm

        .macro  each_sign a, c
        RTOR    each_one, \c
        CFPGE   \a, r0, positive\@
        RTOR    each_minus_one, \c
positive\@:
        .endm

        .macro  each_floor a, c
        FLR     \a, \c
        .endm

        .macro  each_pick i, at, c
        LOD     [\at, \i], \c
        .endm

        .macro  each_choose a, b, i, j
        CFPLT   \a, \b, chosen\@
        RTOR    \j, \i
chosen\@:
        .endm

        .macro  each_add_two x, k, s, l, t
        MPYS    \x, \k, each_first
        MPYS    \x, \l, each_second
        ADDN    each_first, \s, \s
        ADDN    each_second, \t, \t
        .endm

        .macro  each_add_three x, k, s, l, t, m, u
        MPYS    \x, \k, each_first
        MPYS    \x, \l, each_second
        MPYS    \x, \m, each_third
        ADDN    each_first, \s, \s
        ADDN    each_second, \t, \t
        ADDN    each_third, \u, \u
        .endm

        .macro  each_horner x, p, k, q, l, r, m, s, n
        MPYS    \p, \x, \p
        MPYS    \q, \x, \q
        MPYS    \r, \x, \r
        MPYS    \s, \x, \s
        ADDN    \p, \k, \p
        ADDN    \q, \l, \q
        ADDN    \r, \m, \r
        ADDN    \s, \n, \s
        .endm
