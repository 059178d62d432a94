; operations_vector.s - the operations of emission, on a queue of points.
;
; An operand is one quantity of the points: a vector here, a number in
; operations_scalar.s. Both files define the same operations under the same
; names, so kernels are written once and both forms give equal results, bit for
; bit.
;
;       each_times a, b, c            c = a b
;       each_scale a, k, c            c = a k         k: one number for all
;       each_plus a, b, c             c = a + b
;       each_shift a, k, c            c = a + k
;       each_minus a, b, c            c = a - b
;       each_from k, a, c             c = k - a
;       each_over a, b, c             c = a / b
;       each_reciprocal a, c          c = 1 / a
;       each_root a, c                c = sqrt a
;       each_copy a, c                c = a
;       each_same k, c                c = k
;       each_sign a, c                c = 1, or -1 if a is below 0
;       each_floor a, c               c = greatest integer <= a, exponent 0
;       each_pick i, at, c            c = word i of the table at the address
;       each_choose a, b, i, j        i = j if a is not below b
;       each_add_two x, k, s, l, t    s = s + x k,  t = t + x l
;       each_add_three x, k, s, l, t, m, u            also u = u + x m
;       each_horner x, p, k, q, l, r, m, s, n         p = p x + k, likewise
;                                                     q, r and s
;
; Two streams of the pipes are joined where a link allows it. A link takes two
; vectors and one number. The scalar form interleaves the operations of several
; sums, so that none waits for another.

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
