; disc_scalar.s - intersects one ray with a disc or a ring.
;
;       CALL DISC (RAY, PRIMITIVE, SEGMENT)
;
; The arguments are those of sphere_scalar.s, the method is that of
; disc_vector.s.

        shape_from r55                  ; after t6
        .equ    DISC_REGISTERS, 31

        .data
disc_save:      .space DISC_REGISTERS
        .code

        .macro  disc_axis o, d, center, into, work
        SUBN    \o, \center, \into
        MPYS    tin, \d, \work
        ADDN    \work, \into, \into
        .endm

        .kernel disc
disc:
        enter_kernel disc_save, DISC_REGISTERS, 9, tiny
        intersect_plane disc_missed
        RTOR    t2, tin
        disc_axis ox, dx, sh4, t0, t3
        disc_axis oy, dy, sh5, t1, t4
        disc_axis oz, dz, sh6, t2, t5
        dot     t0, t1, t2, t0, t1, t2, t3, t4
        CFPLT   sh7, t3, disc_missed
        CFPLT   t3, sh8, disc_missed
        RTOR    tin, tout
        leave_kernel tiny
disc_missed:
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel tiny
        .endkernel
