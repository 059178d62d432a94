; normal_quartic_vector.s - the normals of shapes whose crossings the root
; solver finds; see normal_vector.s.

        .kernel shade

; Torus: the gradient of (x^2 + z^2 + rho y^2 + b0)^2 - a0 (x^2 + z^2), with
; g = x^2 + z^2 + rho y^2 + b0:  N = ((g - a0/2) x, rho g y, (g - a0/2) z).
normal_torus:
        load_record P_SHAPE, 4, sh0
        MPYSV   [qx], [qx], [v0]
        MPYSV   [qz], [qz], [v1]
        ADDNV   [v1], [v0], [v0]
        MPYSV   [qy], [qy], [v1]
        LINKV
        MPYSV   [v1], sh0, [v1]
        ADDNV   [v1], [v0], [v0]
        ADDNV   [v0], sh1, [v0]                 ; g
        MPYSV   [v0], [qy], [v1]
        MPYSV   [v1], sh0, [ny]
        SUBNV   [v0], sh3, [v0]
        MPYSV   [v0], [qx], [nx]
        MPYSV   [v0], [qz], [nz]
        BIM     gradient_normal

; Quartic surface: the gradient of F, grouped as in quartic_terms.s.  Of each
; row B (in v0, its derivative by z in v1), each group A (v2, by y v3, by z v4)
; and F (v5, its gradient in n) Horner's rule is
;
;   value := value x + c,    derivative := derivative x + value before
        .macro  gradient_step c, x, work
        MPYSV   [\c], [\x], [\c]
        ADDNV   [\work], [\c], [\c]
        .endm

; The row of the words from sh0 on; its first word is the first coefficient.
        .macro  gradient_term c
        gradient_step v1, qz, v0
        LINKV
        MPYSV   [v0], [qz], [v0]
        ADDNV   [v0], \c, [v0]
        .endm

        .macro  gradient_row first
        VTOV    \first, [v0]
        VTOV    r0, [v1]
        .endm

        .macro  gradient_group_row
        gradient_step v3, qy, v2
        gradient_step v2, qy, v0
        gradient_step v4, qy, v1
        .endm

        .macro  gradient_group words
        ELEN    table_at, \words
        SWAP    [table_at], sh0, [r0]
        IX      table_at, 64 * \words
        VTOV    sh0, [v2]
        VTOV    r0, [v3]
        VTOV    r0, [v4]
        gradient_rows \words
        gradient_step nx, qx, v5
        gradient_step v5, qx, v2
        gradient_step ny, qx, v3
        gradient_step nz, qx, v4
        .endm

normal_quartic:
        load_field P_TABLE, table_at
        VTOV    r0, [nx]
        VTOV    r0, [ny]
        VTOV    r0, [nz]
        VTOV    r0, [v5]
        gradient_group 1
        gradient_group 3
        gradient_group 6
        gradient_group 10
        gradient_group 15
        BIM     gradient_normal

; Steiner patch, at the parameters of the hit: with Hs = K1 + 2 K3 s + K4 t,
; Ht = K2 + K4 s + 2 K5 t and X told from the centre,
;   N = (Hs.xyz - X Hs.w) x (Ht.xyz - X Ht.w)
        .share  scratch
        .regs   r233, hx0, hy0, hz0, hx1, hy1, hz1, hx2, hy2, hz2, hx3, hy3
        .regs   r244, hz3, hx4, hy4, hz4, hx5, hy5, hz5
        .endshare

        .macro  tangent k, square, cross, this, other, sum
        ADDN    \square, \square, s0
        LINKV
        MPYSV   [\this], s0, [\sum]
        ADDNV   [\sum], \k, [\sum]
        LINKV
        MPYSV   [\other], \cross, [v7]
        ADDNV   [v7], [\sum], [\sum]
        .endm

; e less its part in w, [w], times the point's coordinate q - center.
        .macro  less_weight q, center, w, e
        LINKV
        SUBNV   [\q], \center, [v7]
        MPYSV   [v7], [\w], [v7]
        SUBNV   [\e], [v7], [\e]
        .endm

        .macro  tangents
        VXTOV   [at], [hit_s], [cr]
        VXTOV   [at], [hit_t], [cg]
        load_field P_TABLE, shape_at
        ELEN    shape_at, 18
        SWAP    [shape_at], hx0, [r0]
        tangent hx1, hx3, hx4, cr, cg, v0
        tangent hy1, hy3, hy4, cr, cg, v1
        tangent hz1, hz3, hz4, cr, cg, v2
        tangent hx2, hx5, hx4, cg, cr, v3
        tangent hy2, hy5, hy4, cg, cr, v4
        tangent hz2, hz5, hz4, cg, cr, v5
        .endm

normal_rational_steiner:
        tangents
        load_record P_SHAPE, 3, sh0
        load_field P_TABLE, shape_at
        IX      shape_at, 64 * 18
        ELEN    shape_at, 6
        SWAP    [shape_at], sh3, [r0]
        tangent sh4, sh6, sh7, cr, cg, v6
        less_weight qx, sh0, v6, v0
        less_weight qy, sh1, v6, v1
        less_weight qz, sh2, v6, v2
        tangent sh5, sh8, sh7, cg, cr, v6
        less_weight qx, sh0, v6, v3
        less_weight qy, sh1, v6, v4
        less_weight qz, sh2, v6, v5
        BIM     normal_patch
normal_steiner:
        tangents
normal_patch:
        cross   v0, v1, v2, v3, v4, v5, nx, ny, nz, v7
        BIM     gradient_normal
        .endkernel
