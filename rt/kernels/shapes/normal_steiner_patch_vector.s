; normal_steiner_patch_vector.s - computes the normals of Steiner patches
; (normal_vector.s).

        .kernel shade
; At the parameters of the hit, with Hs = K1 + 2 K3 s + K4 t,
; Ht = K2 + K4 s + 2 K5 t and X relative to the centre:
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

; Subtracts from e its part in w: [w] times the point's coordinate q - center.
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
