; columns_scalar.s - the operations of emission, on one point at a time; columns_vector.s
; says what they are.

        .regs   r191, column_first, column_second, column_third

        .macro  column_times a, b, c
        MPYS    \a, \b, \c
        .endm

        .macro  column_scale a, k, c
        MPYS    \a, \k, \c
        .endm

        .macro  column_plus a, b, c
        ADDN    \a, \b, \c
        .endm

        .macro  column_shift a, k, c
        ADDN    \a, \k, \c
        .endm

        .macro  column_minus a, b, c
        SUBN    \a, \b, \c
        .endm

        .macro  column_from k, a, c
        SUBN    \k, \a, \c
        .endm

        .macro  column_over a, b, c
        DIVS    \a, \b, \c
        .endm

        .macro  column_reciprocal a, c
        DIVS    column_one, \a, \c
        .endm

        .macro  column_root a, c
        SQRT    \a, \c
        .endm

        .macro  column_copy a, c
        RTOR    \a, \c
        .endm

        .macro  column_same k, c
        RTOR    \k, \c
        .endm

        .macro  column_sign a, c
        RTOR    column_one, \c
        CFPGE   \a, r0, positive\@
        RTOR    column_minus_one, \c
positive\@:
        .endm

        .macro  column_floor a, c
        FLR     \a, \c
        .endm

        .macro  column_pick i, at, c
        LOD     [\at, \i], \c
        .endm

        .macro  column_choose a, b, i, j
        CFPLT   \a, \b, chosen\@
        RTOR    \j, \i
chosen\@:
        .endm

        .macro  column_add_two x, k, s, l, t
        MPYS    \x, \k, column_first
        MPYS    \x, \l, column_second
        ADDN    column_first, \s, \s
        ADDN    column_second, \t, \t
        .endm

        .macro  column_add_three x, k, s, l, t, m, u
        MPYS    \x, \k, column_first
        MPYS    \x, \l, column_second
        MPYS    \x, \m, column_third
        ADDN    column_first, \s, \s
        ADDN    column_second, \t, \t
        ADDN    column_third, \u, \u
        .endm

        .macro  column_horner x, p, k, q, l, r, m, s, n
        MPYS    \p, \x, \p
        MPYS    \q, \x, \q
        MPYS    \r, \x, \r
        MPYS    \s, \x, \s
        ADDN    \p, \k, \p
        ADDN    \q, \l, \q
        ADDN    \r, \m, \r
        ADDN    \s, \n, \s
        .endm
