; plane_scalar.s - intersects one ray with a half space.
;
;       CALL PLANE (RAY, PRIMITIVE, SEGMENT)
;
; The arguments are those of sphere_scalar.s, the method is that of
; plane_vector.s.

        shape_from r51                  ; after t2
        .equ    PLANE_REGISTERS, 22

        .data
plane_save:     .space PLANE_REGISTERS
        .code
; Computes t0 = d - N . O, t1 = N . D, t2 = t for the plane in sh0-sh3.
        .macro  intersect_plane parallel
        dot     ox, oy, oz, sh0, sh1, sh2, t0, t2
        SUBN    sh3, t0, t0
        dot     dx, dy, dz, sh0, sh1, sh2, t1, t2
        ABS     t1, t2
        CFPLT   t2, tiny, \parallel
        DIVS    t0, t1, t2
        .endm

        .kernel plane
plane:
        enter_kernel plane_save, PLANE_REGISTERS, 4, tiny
        intersect_plane plane_parallel
        CFPLT   t1, r0, plane_enters
        RTOR    minus_big, tin
        RTOR    t2, tout
        leave_kernel tiny
plane_enters:
        RTOR    t2, tin
        RTOR    big, tout
        leave_kernel tiny
plane_parallel:
        CFPGE   t0, r0, plane_inside
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel tiny
plane_inside:
        RTOR    minus_big, tin
        RTOR    big, tout
        leave_kernel tiny
        .endkernel
