; normal_steiner_patch.s - computes the normal of a Steiner patch
; (normal_vector.s).
;
; At the parameters of the hit, with Hs = K1 + 2 K3 s + K4 t,
; Ht = K2 + K4 s + 2 K5 t and X relative to the centre:
;   N = (Hs.xyz - X Hs.w) x (Ht.xyz - X Ht.w)

        .kernel shade
        .share  normals
        .regs   row0, kx0, ky0, kz0, kx1, ky1, kz1, kx2, ky2, kz2, kx3, ky3, kz3
        .regs   row12, kx4, ky4, kz4, kx5, ky5, kz5
        .endshare

; Computes a tangent along `this` parameter, from the derivative at 0.
        .macro  tangent this, other, x, y, z, xx, yy, zz, e0, e1, e2
        three   ADDN, \xx, \yy, \zz, \xx, \yy, \zz, \xx, \yy, \zz
        line_three \this, \xx, \x, \e0, \this, \yy, \y, \e1, \this, \zz, \z, \e2
        scaled_plus_three \other, kx4, \e0, \e0, \other, ky4, \e1, \e1, \other, kz4, \e2, \e2
        .endm

        .macro  tangents
        load_point_s
        load_point_t
        load_field P_TABLE, table
        load_from table, 18, row0
        tangent point_s, point_t, kx1, ky1, kz1, kx3, ky3, kz3, t0, t1, t2
        tangent point_t, point_s, kx2, ky2, kz2, kx5, ky5, kz5, t3, t4, t5
        .endm

; Subtracts from a tangent its part in w, whose derivative at 0 is k.
        .macro  less_weight this, other, k, square, e0, e1, e2
        ADDN    \square, \square, \square
        line    \this, \square, \k, t6
        scaled_plus \other, sh7, t6, t6
        lowered_times_three qx, sh0, t6, nx, qy, sh1, t6, ny, qz, sh2, t6, nz
        three   minus, \e0, \e1, \e2, nx, ny, nz, \e0, \e1, \e2
        .endm

normal_rational_steiner:
        load_shape 3
        load_field P_TABLE, table
        IX      table, 64 * 18
        load_from table, 6, sh3                 ; K0.w .. K5.w
        tangents
        less_weight point_s, point_t, sh4, sh6, t0, t1, t2
        less_weight point_t, point_s, sh5, sh8, t3, t4, t5
        BIM     normal_patch
normal_steiner:
        tangents
normal_patch:
        cross_product t0, t1, t2, t3, t4, t5, nx, ny, nz
        BIM     gradient_normal
        .endkernel
