; normal_cylinder_clipped.s - computes the normal of a cylinder that is
; intersected by cylinder_clipped.s (normal_vector.s).
;
; A point belongs to the surface of the ray's entry or to that of its exit,
; whichever is nearer.  X is relative to the base and x = X - (X . A) A is its
; part across the axis:
;   side 0    | x . x - r^2 | / (2 r)         N = x / r
;   bottom 1  | p . X + q |                   N = p
;   top 2     the same with the other plane
; If no surface is recorded (CYLINDER_UNRECORDED), it is the nearest of the
; three.

        .kernel shade
; X - B in t0-t2; x in nx, ny, nz.
        .macro  find_across
        load_shape 16
        three   lower, qx, qy, qz, sh0, sh1, sh2, t0, t1, t2
        dot_numbers t0, t1, t2, sh3, sh4, sh5, t3, t4
        minus_scaled t0, t3, sh3, nx
        minus_scaled t1, t3, sh4, ny
        minus_scaled t2, t3, sh5, nz
        .endm

        .macro  side_unit
        scale   nx, sh15, nx
        scale   ny, sh15, ny
        scale   nz, sh15, nz
        .endm

        .macro  from_plane p0, p1, p2, q, distance
        dot_numbers qx, qy, qz, \p0, \p1, \p2, \distance, t7
        raise   \distance, \q, \distance
        .endm

; point_s = the surface; t2 = the distance from the side, t0 and t1 from the
; bottom and the top.
        .ifdef  CYLINDER_UNRECORDED
        .macro  prefer_surface distance, number
        if_nearer \distance, t2, nearer_not\@
        then_copy \distance, t2
        then_set \number, point_s
        end_if  nearer_not\@
        .endm

        .macro  find_clipped_surface
        set     m_zero, point_s
        prefer_surface t0, m_one
        prefer_surface t1, m_two
        .endm
        .else
        .macro  from_surface x, distance
        copy    t2, \distance
        if_equal_number \x, m_one, from_bottom\@
        then_copy t0, \distance
        end_if  from_bottom\@
        if_equal_number \x, m_two, from_top\@
        then_copy t1, \distance
        end_if  from_top\@
        .endm

        .macro  find_clipped_surface
        load_point_s
        load_point_t
        from_surface point_s, t3
        from_surface point_t, t4
        if_nearer t4, t3, recorded_nearer\@
        then_copy point_t, point_s
        end_if  recorded_nearer\@
        .endm
        .endif

        .macro  end_unit number, p0, p1, p2
        if_equal_number point_s, \number, end_not\@
        then_set \p0, nx
        then_set \p1, ny
        then_set \p2, nz
        end_if  end_not\@
        .endm

normal_clipped_cylinder:
        find_across
        dot_product nx, ny, nz, nx, ny, nz, t2, t3
        MPYS    sh6, sh6, sh6
        MPYS    sh15, m_half, spare
        lowered_scale t2, sh6, spare, t2
        side_unit
        from_plane sh7, sh8, sh9, sh10, t0
        from_plane sh11, sh12, sh13, sh14, t1
        find_clipped_surface
        end_unit m_one, sh7, sh8, sh9
        end_unit m_two, sh11, sh12, sh13
        leave_normal

normal_open_clipped_cylinder:
        find_across
        side_unit
        leave_normal
        .endkernel
