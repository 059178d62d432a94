; columns_vector.s - the operations of emission, on a queue of points at a time.
;
; A column is one quantity of the points: here a vector, in columns_scalar.s a number.
; Both files give the same operations under the same names, so that what is
; written with them stands once and is equal in both forms, bit for bit.
;
;       column_times a, b, c            c = a b
;       column_scale a, k, c            c = a k         k: the same for all points
;       column_plus a, b, c             c = a + b
;       column_shift a, k, c            c = a + k
;       column_minus a, b, c            c = a - b
;       column_from k, a, c             c = k - a
;       column_over a, b, c             c = a / b
;       column_reciprocal a, c          c = 1 / a
;       column_root a, c                c = sqrt a
;       column_copy a, c                c = a
;       column_same k, c                c = k
;       column_sign a, c                c = 1, or -1 where a is below 0
;       column_floor a, c               c = the integer not above a, exponent 0
;       column_pick i, at, c            c = word number i from the address at on
;       column_choose a, b, i, j        i = j where a is not below b
;       column_add_two x, k, s, l, t    s = s + x k,  t = t + x l
;       column_add_three x, k, s, l, t, m, u            .. and u = u + x m
;       column_horner x, p, k, q, l, r, m, s, n         p = p x + k, and likewise
;                                                       q, r and s
;
; Two streams of the pipes become one where a link allows it: two vectors and one
; number go into it.  The scalar form does the operations of several sums in turn, so that
; none waits for another.

        .macro  column_times a, b, c
        MPYSV   [\a], [\b], [\c]
        .endm

        .macro  column_scale a, k, c
        MPYSV   [\a], \k, [\c]
        .endm

        .macro  column_plus a, b, c
        ADDNV   [\a], [\b], [\c]
        .endm

        .macro  column_shift a, k, c
        ADDNV   [\a], \k, [\c]
        .endm

        .macro  column_minus a, b, c
        SUBNV   [\a], [\b], [\c]
        .endm

        .macro  column_from k, a, c
        SUBNV   \k, [\a], [\c]
        .endm

        .macro  column_over a, b, c
        DIVSV   [\a], [\b], [\c]
        .endm

        .macro  column_reciprocal a, c
        DIVSV   column_one, [\a], [\c]
        .endm

        .macro  column_root a, c
        SQRTV   [\a], [\c]
        .endm

        .macro  column_copy a, c
        VTOV    [\a], [\c]
        .endm

        .macro  column_same k, c
        VTOV    \k, [\c]
        .endm

        .macro  column_sign a, c
        CMPLTV  [\a], r0, [column_bits]
        VTOV    column_one, [\c]
        VTOV    column_minus_one, [\c] ? [column_bits]
        .endm

        .macro  column_floor a, c
        FLRV    [\a], [\c]
        .endm

        .macro  column_pick i, at, c
        VXTOV   [\i], [\at], [\c]
        .endm

        .macro  column_choose a, b, i, j
        CMPGEV  [\a], [\b], [column_bits]
        VTOV    [\j], [\i] ? [column_bits]
        .endm

        .macro  column_add x, k, s
        LINKV
        MPYSV   [\x], \k, [column_linked]
        ADDNV   [column_linked], [\s], [\s]
        .endm

        .macro  column_add_two x, k, s, l, t
        column_add \x, \k, \s
        column_add \x, \l, \t
        .endm

        .macro  column_add_three x, k, s, l, t, m, u
        column_add_two \x, \k, \s, \l, \t
        column_add \x, \m, \u
        .endm

        .macro  column_horner_step p, x, k
        LINKV
        MPYSV   [\p], [\x], [column_linked]
        ADDNV   [column_linked], \k, [\p]
        .endm

        .macro  column_horner x, p, k, q, l, r, m, s, n
        column_horner_step \p, \x, \k
        column_horner_step \q, \x, \l
        column_horner_step \r, \x, \m
        column_horner_step \s, \x, \n
        .endm
