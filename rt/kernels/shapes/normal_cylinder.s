; normal_cylinder.s - computes the normal of a cylinder (normal_vector.s).
;
; In the frame u, v, w of the axis X - C = (xu, xv, xw).  A point belongs to a
; disk if it is nearer to the disk's plane than to the side:
;   | |xw| - half | < |(xu^2 + xv^2 - r^2) / (2 r)|
; Disk: N = w with the sign of xw.  Side: N = (xu u + xv v) / r.

        .kernel shade
; t0, t1, t2 = the point in the frame of the axis.
        .macro  point_along_axis
        load_shape 16
        three   lower, qx, qy, qz, sh0, sh1, sh2, t3, t4, t5
        dot_numbers t3, t4, t5, sh3, sh4, sh5, t0, t6
        dot_numbers t3, t4, t5, sh6, sh7, sh8, t1, t6
        dot_numbers t3, t4, t5, sh9, sh10, sh11, t2, t6
        .endm

; From the side, for which the condition is true, to the end of the normal.
        .macro  disk_otherwise disk
        leave_or \disk
        otherwise_set sh9, nx
        otherwise_set sh10, ny
        otherwise_set sh11, nz
        otherwise_if_less_number t2, r0, disk_above\@
        then_set_minus sh9, nx
        then_set_minus sh10, ny
        then_set_minus sh11, nz
        end_if  disk_above\@
        leave_normal
        .endm

        .macro  side_part u, v, n, scale
        scale   t0, \u, t5
        scaled_plus t1, \v, t5, t5
        \scale  t5, sh15, \n
        .endm

        .macro  cylinder_side_normal scale
        side_part sh3, sh6, nx, \scale
        side_part sh4, sh7, ny, \scale
        side_part sh5, sh8, nz, \scale
        .endm

normal_cylinder:
        point_along_axis
        times   t0, t0, t3
        times   t1, t1, t4
        plus    t4, t3, t3
        lowered_scale t3, sh12, sh14, t3
        absolute_lower t2, sh13, t4
        if_not_nearer t4, t3, cylinder_disk
        cylinder_side_normal then_scale
        disk_otherwise cylinder_disk

normal_open_cylinder:
        point_along_axis
        cylinder_side_normal scale
        leave_normal
        .endkernel

        .ifdef  HISTORICAL
        .include "shapes/normal_cylinder_clipped.s"
        .endif
