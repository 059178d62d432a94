; elliptical_torus_vector.s - intersects a queue of rays with an elliptical
; torus about the y axis.  Formulas, arguments and results are those of
; torus_vector.s.

        .macro  elliptical_polynomial
        MPYSV   [lane_dx], [lane_dx], [e0]
        MPYSV   [lane_dz], [lane_dz], [e1]
        ADDNV   [e1], [e0], [e0]                ; f
        MPYSV   [lane_ox], [lane_dx], [e1]
        MPYSV   [lane_oz], [lane_dz], [e2]
        ADDNV   [e2], [e1], [e1]                ; l
        MPYSV   [lane_ox], [lane_ox], [e2]
        MPYSV   [lane_oz], [lane_oz], [e3]
        ADDNV   [e3], [e2], [e2]                ; g
        MPYSV   [lane_dy], [lane_dy], [e3]
        LINKV
        MPYSV   [e3], sh0, [e3]
        ADDNV   [e3], [e0], [e3]                ; a
        MPYSV   [lane_oy], [lane_dy], [e4]
        LINKV
        MPYSV   [e4], sh0, [e4]
        ADDNV   [e4], [e1], [e4]
        ADDNV   [e4], [e4], [e4]                ; b
        MPYSV   [lane_oy], [lane_oy], [e5]
        LINKV
        MPYSV   [e5], sh0, [e5]
        ADDNV   [e5], [e2], [e5]
        ADDNV   [e5], sh1, [e5]                 ; c
        MPYSV   [e3], [e3], [k4]
        LINKV
        MPYSV   [e3], [e4], [k3]
        ADDNV   [k3], [k3], [k3]
        LINKV
        MPYSV   [e3], [e5], [k2]
        ADDNV   [k2], [k2], [k2]
        MPYSV   [e4], [e4], [e6]
        ADDNV   [e6], [k2], [k2]
        LINKV
        MPYSV   [e0], sh2, [e6]
        SUBNV   [k2], [e6], [k2]
        LINKV
        MPYSV   [e4], [e5], [k1]
        ADDNV   [k1], [k1], [k1]
        LINKV
        MPYSV   [e1], sh7, [e6]
        SUBNV   [k1], [e6], [k1]
        MPYSV   [e5], [e5], [k0]
        LINKV
        MPYSV   [e2], sh2, [e6]
        SUBNV   [k0], [e6], [k0]
        .endm

        .kernel torus
elliptical_torus:
        load_record P_SHAPE, 10, sh0
        find_lanes ox, oy, oz, sh4, torus_miss
        leave_above torus_miss
        take_lanes
        elliptical_polynomial
        solve_lanes sh8
        BIM     0, link_kernel

elliptical_torus_solid:
        load_record P_SHAPE, 10, sh0
        find_all_lanes ox, oy, oz, sh4, torus_passed
        leave_above torus_passed
        take_lanes
        elliptical_polynomial
        solve_segments sh8
        BIM     0, link_kernel
        .endkernel
