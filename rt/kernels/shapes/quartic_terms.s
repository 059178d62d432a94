; quartic_terms.s - forms the quartic of a quartic surface along a ray, for the
; scalar and the vector form.
;
;   F(x, y, z) = ((((A0 x + A1) x + A2) x + A3) x + A4
;   Am(y, z) = (((B0 y + B1) y + ..) y + Bm,   Bj(z) = b0 z^j + .. + bj
;
; x, y, z are linear in the distance t from the ray's closest approach to the
; origin: o + d t.  All sums are polynomials of t, formed by Horner's rule with
; o + d t as the argument.  The 35 coefficients are used in POV-Ray's order:
; group by group A0 .. A4, and in each group B0, B1 ..
;
; Most quartics have few terms, and zero coefficients are skipped.  used_terms =
; 1 if the group has a term so far, used_groups = 1 if F has.
;
; Each form defines the macros
;   term<p> c              Am += c z^p
;   times_y m, times_x m   Am, F times o + d t, then of degree m
;   clear_group m          Am := 0
;   add_group m            F += Am
; Source: derived here; the order is that of POV-Ray's quartic.

        .macro  quartic_row0
        term0   sh0
        .endm

        .macro  quartic_row1
        times_y 1
        term1   sh1
        term0   sh2
        .endm

        .macro  quartic_row2
        times_y 2
        term2   sh3
        term1   sh4
        term0   sh5
        .endm

        .macro  quartic_row3
        times_y 3
        term3   sh6
        term2   sh7
        term1   sh8
        term0   sh9
        .endm

        .macro  quartic_row4
        times_y 4
        term4   sh10
        term3   sh11
        term2   sh12
        term1   sh13
        term0   sh14
        .endm

; Adds the next group of the table and advances table_at.
        .macro  quartic_group degree, words
        ELEN    table_at, \words
        SWAP    [table_at], sh0, [r0]
        IX      table_at, 64 * \words
        ES      used_terms, 0
        clear_group \degree
        quartic_row0
        .if     \degree > 0
        quartic_row1
        .endif
        .if     \degree > 1
        quartic_row2
        .endif
        .if     \degree > 2
        quartic_row3
        .endif
        .if     \degree > 3
        quartic_row4
        .endif
        IBXEQ   used_groups, r0, r0, group_first\@
        times_x \degree
group_first\@:
        IBXEQ   used_terms, r0, r0, group_none\@
        add_group \degree
        ES      used_groups, 1
group_none\@:
        .endm

        .macro  quartic_groups
        ES      used_groups, 0
        quartic_group 0, 1
        quartic_group 1, 3
        quartic_group 2, 6
        quartic_group 3, 10
        quartic_group 4, 15
        .endm
