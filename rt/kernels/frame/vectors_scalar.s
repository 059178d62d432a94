; vectors_scalar.s - three-dimensional vectors of the scalar program.
;
; Results take five clocks, so independent products precede the sums that depend
; on them.

; The operations of kernels that are written once.
        .include "forms.s"
        scalar_form , third, fourth, t9

; sum = x . u, in the order (x1 u1 + x0 u0) + x2 u2.
        .macro  dot x0, x1, x2, u0, u1, u2, sum, work
        three   MPYS, \x0, \x1, \x2, \u0, \u1, \u2, \sum, \work, third
        ADDN    \work, \sum, \sum
        ADDN    third, \sum, \sum
        .endm

        .macro  dot_product x0, x1, x2, y0, y1, y2, sum, work
        dot     \x0, \x1, \x2, \y0, \y1, \y2, \sum, \work
        .endm

        .macro  dot_numbers x0, x1, x2, k0, k1, k2, sum, work
        dot     \x0, \x1, \x2, \k0, \k1, \k2, \sum, \work
        .endm

; Computes three such sums of x with the rows a, b, c at a time, without waits.
        .macro  dot_rows x0, x1, x2, a0, a1, a2, b0, b1, b2, c0, c1, c2, a, b, c, w0, w1, w2, w3
        three_by MPYS, \x0, \a0, \b0, \c0, \a, \b, \c
        three_by MPYS, \x1, \a1, \b1, \c1, \w0, \w1, \w2
        three_by MPYS, \x2, \a2, \b2, \c2, \w3, third, fourth
        three   ADDN, \w0, \w1, \w2, \a, \b, \c, \a, \b, \c
        three   ADDN, \w3, third, fourth, \a, \b, \c, \a, \b, \c
        .endm

        .macro  normalise_by unit, x0, x1, x2, length, work
        dot     \x0, \x1, \x2, \x0, \x1, \x2, \length, \work
        SQRT    \length, \length
        DIVS    \unit, \length, \work
        three_by MPYS, \work, \x0, \x1, \x2, \x0, \x1, \x2
        .endm

; Like normalise_by, but a vector without length becomes (1, 0, 0).
        .macro  direction_by unit, x0, x1, x2, length, work
        normalise_by \unit, \x0, \x1, \x2, \length, \work
        CFPNE   \length, r0, direction\@
        RTOR    \unit, \x0
        RTOR    m_zero, \x1
        RTOR    m_zero, \x2
direction\@:
        .endm

; Like renormalise in queue.s.
        .macro  renormalise_by unit, half, x0, x1, x2, scale, work
        dot     \x0, \x1, \x2, \x0, \x1, \x2, \scale, \work
        SUBN    \unit, \scale, \scale
        MPYS    \scale, \half, \scale
        ADDN    \scale, \unit, \scale
        three_by MPYS, \scale, \x0, \x1, \x2, \x0, \x1, \x2
        .endm

; y = A x for the symmetric matrix of a quadric's record.
        .macro  matrix_rows x0, x1, x2, y0, y1, y2, w0, w1, w2, w3
        dot_rows \x0, \x1, \x2, sh3, sh6, sh7, sh6, sh4, sh8, sh7, sh8, sh5, \y0, \y1, \y2, \w0, \w1, \w2, \w3
        .endm

        .macro  cross_product a0, a1, a2, b0, b1, b2, c0, c1, c2
        three   MPYS, \a1, \a2, \a0, \b2, \b0, \b1, \c0, \c1, \c2
        three   MPYS, \a2, \a0, \a1, \b1, \b2, \b0, t8, t9, third
        three   SUBN, \c0, \c1, \c2, t8, t9, third, \c0, \c1, \c2
        .endm
