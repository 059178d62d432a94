; normal_cone.s - computes the normal of a cone (normal_vector.s).
;
; In the frame u, v, w of the axis X - C = (xu, xv, xw).  With
; rho = sqrt(xu^2 + xv^2), r = r0 + k xw, g = 1/sqrt(1 + k^2), a point belongs
; to a disk if it is nearer to the disk's plane than to the side:
;   | |xw| - half | < |rho - r| g
; Disk: N = w with the sign of xw.  Side: N = g (xu/rho u + xv/rho v - k w).
; At the apex, rho = 0, u replaces the quotients.

        .kernel shade
; t6 = rho; t7 = rho, or 1 at the apex.
        .macro  cone_point
        point_along_axis
        times   t0, t0, t3
        times   t1, t1, t4
        plus    t4, t3, t3
        root    t3, t6
        default t6, t7
        if_equal_number t6, r0, off_axis\@
        then_set_or_copy m_one, t6, t7
        then_set m_one, t0
        end_if  off_axis\@
        .endm

        .macro  slope_part u, v, w, n, lower
        MPYS    sh13, \w, spare
        scale   t0, \u, t5
        scaled_plus t1, \v, t5, t5
        \lower  t5, spare, \n
        .endm

        .macro  cone_side_normal lower
        into    sh15, t7, t5                    ; g / rho
        times   t0, t5, t0
        times   t1, t5, t1
        MPYS    sh13, sh15, sh13                ; k g
        slope_part sh3, sh6, sh9, nx, \lower
        slope_part sh4, sh7, sh10, ny, \lower
        slope_part sh5, sh8, sh11, nz, \lower
        .endm

normal_cone:
        cone_point
        line    t2, sh13, sh12, t3
        difference_scale t6, t3, sh15, t3
        absolute_lower t2, sh14, t4
        if_not_nearer t4, t3, cone_disk
        cone_side_normal then_lower
        disk_otherwise cone_disk

normal_open_cone:
        cone_point
        cone_side_normal lower
        leave_normal
        .endkernel
