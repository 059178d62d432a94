; normal_box.s - computes the normal of a box (normal_vector.s).

        .kernel shade
; The face is the one with the nearest plane: the axis with the smallest
; | |X - C| - half edge |; x before y before z if two are equal.  Distances are
; compared and not ratios, because a box may be flat.
normal_box:
        load_shape 12
        three   lower, qx, qy, qz, sh6, sh7, sh8, t0, t1, t2
        set     m_zero, nx
        set     m_zero, ny
        set     m_zero, nz
        absolute_lower_three t0, sh9, t3, t1, sh10, t4, t2, sh11, t5
        if_not_nearer t4, t3, normal_box_yz
        and_if_not_nearer t5, t3, normal_box_yz
        then_sign t0, m_one, m_minus_one, nx, t6
        leave_or normal_box_yz
        otherwise_if_not_nearer t5, t4, normal_box_z
        then_sign t1, m_one, m_minus_one, ny, t6
        leave_or normal_box_z
        then_sign t2, m_one, m_minus_one, nz, t6, rest
        leave_normal
        .endkernel
