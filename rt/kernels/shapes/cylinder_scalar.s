; cylinder_scalar.s - intersects one ray with a circular cylinder, solid or
; open.
;
;       CALL CYLINDER (RAY, PRIMITIVE, SEGMENT)
;       CALL OPEN_CYLINDER (RAY, PRIMITIVE, SEGMENT)
;
; The arguments are those of sphere_scalar.s, the method is that of
; cylinder_vector.s.

        shape_from r58                  ; after t9
        .equ    CYLINDER_REGISTERS, 40

; The ray in the frame u, v, w: o = t7, t8, t5; d = t0, t1, t6.  Changes t2, t3,
; t4, t9.
        .macro  into_frame
        three   SUBN, ox, oy, oz, sh0, sh1, sh2, t0, t1, t2
        dot_rows t0, t1, t2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10, sh11, t7, t8, t5, t3, t4, t6, t9
        dot_rows dx, dy, dz, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10, sh11, t0, t1, t6, t2, t3, t4, t9
        .endm

; Computes tin, tout of the side, or branches to miss.  Leaves the origin along
; the axis in t5, the direction along it in t6.
        .macro  cylinder_side miss
        into_frame
        MPYS    t0, t0, t2
        MPYS    t1, t1, t3
        MPYS    tiny, tiny, t4
        ADDN    t3, t2, t2              ; a
        CFPLT   t2, t4, cylinder_along\@
        DIVS    one, t2, t2
        MPYS    t7, t0, t3
        MPYS    t8, t1, t4
        ADDN    t4, t3, t3
        SUBN    r0, t3, t3
        MPYS    t3, t2, t3              ; t0 of the closest approach
        MPYS    t3, t0, t0
        MPYS    t3, t1, t1
        ADDN    t7, t0, t0
        ADDN    t8, t1, t1
        MPYS    t0, t0, t0
        MPYS    t1, t1, t1
        ADDN    t1, t0, t4
        SUBN    sh12, t4, t0
        MPYS    t0, t2, t0              ; h
        CFPLT   t0, r0, \miss
        SQRT    t0, t0
        SUBN    t3, t0, tin
        ADDN    t3, t0, tout
        BIM     cylinder_sided\@
cylinder_along\@:
        MPYS    t7, t7, t7
        MPYS    t8, t8, t8
        ADDN    t8, t7, t7
        CFPLT   sh12, t7, \miss
        RTOR    minus_big, tin
        RTOR    big, tout
cylinder_sided\@:
        .endm

        .ifdef  CYLINDER_HALF_SPACES
        .include "shapes/cylinder_half_spaces.s"
        .else
        .macro  cut_by_ends miss
        SUBN    r0, sh13, t9
        slab    t5, t6, t9, sh13, \miss
        .endm
        .endif

        .data
cylinder_save:  .space CYLINDER_REGISTERS
        .code
        .kernel cylinder
        .ifndef CYLINDER_IN_FRAME
cylinder:
        enter_kernel cylinder_save, CYLINDER_REGISTERS, 14
        cylinder_side cylinder_miss
        cut_by_ends cylinder_miss
        leave_kernel
        .endif
cylinder_miss:
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel

; Keeps the crossings between the disks: t1, t2 = the two crossings; t3, t4 =
; their distances from the middle along the axis; o, d = the ray along the axis.
        .macro  keep_between_disks o, d, half, miss
        RTOR    tin, t1
        RTOR    tout, t2
        MPYS    t1, \d, t3
        ADDN    t3, \o, t3
        ABS     t3, t3
        MPYS    t2, \d, t4
        ADDN    t4, \o, t4
        ABS     t4, t4
        CFPLT   \half, t3, first_beyond\@
        CFPGE   \half, t4, disks_done\@
        RTOR    t1, tout
        BIM     disks_done\@
first_beyond\@:
        CFPLT   \half, t4, \miss
        RTOR    t2, tin
disks_done\@:
        .endm

open_cylinder:
        enter_kernel cylinder_save, CYLINDER_REGISTERS, 14
        cylinder_side cylinder_miss
        keep_between_disks t5, t6, sh13, cylinder_miss
        leave_kernel
        .endkernel
