; operations_vector.s - the operations of emission, on a queue of points at a time.
;
; An operand is one quantity of the points: here a vector, in operations_scalar.s a number.
; Both files give the same operations under the same names, so that what is
; written with them stands once and is equal in both forms, bit for bit.
;
;       each_times a, b, c            c = a b
;       each_scale a, k, c            c = a k         k: the same for all points
;       each_plus a, b, c             c = a + b
;       each_shift a, k, c            c = a + k
;       each_minus a, b, c            c = a - b
;       each_from k, a, c             c = k - a
;       each_over a, b, c             c = a / b
;       each_reciprocal a, c          c = 1 / a
;       each_root a, c                c = sqrt a
;       each_copy a, c                c = a
;       each_same k, c                c = k
;       each_sign a, c                c = 1, or -1 where a is below 0
;       each_floor a, c               c = the integer not above a, exponent 0
;       each_pick i, at, c            c = word number i from the address at on
;       each_choose a, b, i, j        i = j where a is not below b
;       each_add_two x, k, s, l, t    s = s + x k,  t = t + x l
;       each_add_three x, k, s, l, t, m, u            .. and u = u + x m
;       each_horner x, p, k, q, l, r, m, s, n         p = p x + k, and likewise
;                                                       q, r and s
;
; Two streams of the pipes become one where a link allows it: two vectors and one
; number go into it.  The scalar form does the operations of several sums in turn, so that
; none waits for another.

        .macro  each_times a, b, c
        MPYSV   [\a], [\b], [\c]
        .endm

        .macro  each_scale a, k, c
        MPYSV   [\a], \k, [\c]
        .endm

        .macro  each_plus a, b, c
        ADDNV   [\a], [\b], [\c]
        .endm

        .macro  each_shift a, k, c
        ADDNV   [\a], \k, [\c]
        .endm

        .macro  each_minus a, b, c
        SUBNV   [\a], [\b], [\c]
        .endm

        .macro  each_from k, a, c
        SUBNV   \k, [\a], [\c]
        .endm

        .macro  each_over a, b, c
        DIVSV   [\a], [\b], [\c]
        .endm

        .macro  each_reciprocal a, c
        DIVSV   each_one, [\a], [\c]
        .endm

        .macro  each_root a, c
        SQRTV   [\a], [\c]
        .endm

        .macro  each_copy a, c
        VTOV    [\a], [\c]
        .endm

        .macro  each_same k, c
        VTOV    \k, [\c]
        .endm

        .macro  each_sign a, c
        CMPLTV  [\a], r0, [each_bits]
        VTOV    each_one, [\c]
        VTOV    each_minus_one, [\c] ? [each_bits]
        .endm

        .macro  each_floor a, c
        FLRV    [\a], [\c]
        .endm

        .macro  each_pick i, at, c
        VXTOV   [\i], [\at], [\c]
        .endm

        .macro  each_choose a, b, i, j
        CMPGEV  [\a], [\b], [each_bits]
        VTOV    [\j], [\i] ? [each_bits]
        .endm

        .macro  each_add x, k, s
        LINKV
        MPYSV   [\x], \k, [each_linked]
        ADDNV   [each_linked], [\s], [\s]
        .endm

        .macro  each_add_two x, k, s, l, t
        each_add \x, \k, \s
        each_add \x, \l, \t
        .endm

        .macro  each_add_three x, k, s, l, t, m, u
        each_add_two \x, \k, \s, \l, \t
        each_add \x, \m, \u
        .endm

        .macro  each_horner_step p, x, k
        LINKV
        MPYSV   [\p], [\x], [each_linked]
        ADDNV   [each_linked], \k, [\p]
        .endm

        .macro  each_horner x, p, k, q, l, r, m, s, n
        each_horner_step \p, \x, \k
        each_horner_step \q, \x, \l
        each_horner_step \r, \x, \m
        each_horner_step \s, \x, \n
        .endm
