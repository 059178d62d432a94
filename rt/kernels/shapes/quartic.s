; quartic.s - intersects rays with a quartic surface, POV-Ray's quartic with its
; 35 coefficients.
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
; The surface may be unbounded, so crossings are searched up to
;
;   high = 2 max(1, |k3/k4|, |k2/k4|^(1/2), |k0/k4|^(1/4), (|k1/k4| / q)^(1/2))
;
; where q is the maximum of the previous terms.  No root is beyond: if q is less
; than |k1/k4|^(1/3), the last term is greater than that.  high is at most 1e7,
; as in POV-Ray.
;
;       CALL QUARTIC_SURFACE (RAY, PRIMITIVE, SEGMENT)
;       CALL QUARTIC_SOLID (RAY, PRIMITIVE, SEGMENTS)
;
; In:  ox oy oz dx dy dz lower, near long; the primitive's record.
; Out: tin = tout = the nearest crossing; a miss is big, minus_big.
;      quartic_solid: three segments (segments_vector.s).
; Record: farthest distance, resolution.  Table: its 35 coefficients.
; Source: derived here; the order is that of POV-Ray's quartic; the bound is
; Fujiwara's, without cube roots.

        include_form lanes
        include_form quartic

; z and its powers z10 + z11 t, z20 + z21 t + z22 t^2 ..
        .reg    z10, t2
        .reg    z11, dz

; Am += c z^p.
        .macro  term p, c
        CFPEQ   \c, r0, term_none\@
        .if     \p == 0
        ray_raise a0, \c, a0
        .else
        ray_scaled_plus_two z\p\()0, \c, a0, a0, z\p\()1, \c, a1, a1
        .endif
        .if     \p == 2
        ray_scaled_plus z22, \c, a2, a2
        .elseif \p > 2
        ray_scaled_plus_two z\p\()2, \c, a2, a2, z\p\()3, \c, a3, a3
        .endif
        .if     \p == 4
        ray_scaled_plus z44, \c, a4, a4
        .endif
        ES      used_terms, 1
term_none\@:
        .endm

; z^2, z^3, z^4, each the previous power times o + d t.
        .macro  power_of_z
        ray_times t2, t2, z20
        ray_product_double t2, dz, z21
        ray_times dz, dz, z22
        ray_times z20, t2, z30
        ray_times z20, dz, a0
        ray_times z22, t2, z32
        ray_times z21, t2, z31
        ray_times z21, dz, a1
        ray_times z22, dz, z33
        ray_times z30, t2, z40
        ray_times z30, dz, a2
        ray_plus a0, z31, z31
        ray_plus a1, z32, z32
        ray_times z33, t2, z43
        ray_times z33, dz, z44
        ray_times z31, t2, z41
        ray_times z31, dz, a3
        ray_times z32, t2, z42
        ray_times z32, dz, a4
        three   ray_plus, a2, a3, a4, z41, z42, z43, z41, z42, z43
        .endm

; c(i) := c(i) o + c(i-1) d, up to the degree, which is that of the product.
        .macro  multiply o, d, degree, c0, c1, c2, c3, c4
        .if     \degree == 4
        ray_times \c3, \d, \c4
        ray_times \c2, \d, b2
        ray_times \c3, \o, \c3
        .elseif \degree == 3
        ray_times \c2, \d, \c3
        .elseif \degree == 2
        ray_times \c1, \d, \c2
        .else
        ray_times \c0, \d, \c1
        .endif
        .if     \degree >= 3
        ray_times \c1, \d, b1
        ray_times \c2, \o, \c2
        .endif
        .if     \degree >= 2
        ray_times \c1, \o, \c1
        ray_times \c0, \d, b0
        .endif
        ray_times \c0, \o, \c0
        .if     \degree >= 4
        ray_plus b2, \c3, \c3
        .endif
        .if     \degree >= 3
        ray_plus b1, \c2, \c2
        .endif
        .if     \degree >= 2
        ray_plus b0, \c1, \c1
        .endif
        .endm

        .macro  times_y degree
        IBXEQ   used_terms, r0, r0, times_none\@
        multiply t1, dy, \degree, a0, a1, a2, a3, a4
times_none\@:
        .endm

; F := F (o + d t) + Am.
        .macro  times_x degree
        multiply t0, dx, \degree, k0, k1, k2, k3, k4
        .endm

; a0 .. := 0, and k0 .. += a0 .., up to the degree.
        .macro  clear_group degree
        .rept   \degree + 1
        ray_clear a\+
        .endr
        .endm

        .macro  add_group degree
        .rept   \degree + 1
        ray_plus k\+, a\+, k\+
        .endr
        .endm

        .macro  quartic_row0
        term    0, sh0
        .endm

        .macro  quartic_row1
        times_y 1
        term    1, sh1
        term    0, sh2
        .endm

        .macro  quartic_row2
        times_y 2
        term    2, sh3
        term    1, sh4
        term    0, sh5
        .endm

        .macro  quartic_row3
        times_y 3
        term    3, sh6
        term    2, sh7
        term    1, sh8
        term    0, sh9
        .endm

        .macro  quartic_row4
        times_y 4
        term    4, sh10
        term    3, sh11
        term    2, sh12
        term    1, sh13
        term    0, sh14
        .endm

; Adds the next group of the table and advances table_at.
        .macro  quartic_group degree, words
        load_from table_at, \words, sh0
        IX      table_at, 64 * \words
        ES      used_terms, 0
        clear_group \degree
        .rept   \degree + 1
        quartic_row\+
        .endr
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

; Computes k4 .. k0 about the closest approach, and `high`.
        .macro  surface_polynomial
        closest_approach ox, oy, oz, t0, t1, t2, surface_along, t4, t5
        power_of_z
        .rept   5
        ray_clear k\+
        .endr
        load_surface
        quartic_groups
        find_high
        .endm

        .kernel quartic_surface
quartic_surface:
        enter_surface
        surface_polynomial
        leave_surface

quartic_solid:
        enter_surface
        surface_polynomial
        ray_from r0, surface_high, surface_low
        quartic_polynomial surface_low, e0, k4, k3, k2, k1, k0
        leave_solid
        .endkernel
