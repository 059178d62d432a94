; mesh_screen_bounds_scalar.s - tests one ray against the windows of a mesh if
; the ray goes through a viewpoint.  The formulas are those of
; mesh_screen_bounds_vector.s.  A ray that is not a shadow ray goes through a
; viewpoint if its origin is one.

        .reg    mesh_u, inverse_x
        .reg    mesh_v, inverse_y
        .reg    mesh_forward, inverse_z
        .reg    mesh_bounds, size_x
; The lowest and highest u and v, and the lowest z.
        .regs   box_x, window0, window1, window2, window3, window4
; The viewpoint, in the registers of the boxes until the traversal begins.
        .share  local
        .regs   r100, viewpoint_x, viewpoint_y, viewpoint_z, viewpoint_axis
        .regs   r104, viewpoint_sign, viewpoint_far, viewpoint_bounds
        .endshare

        .macro  viewpoint_axes w, u, v
        copy_three \w, \u, \v, mesh_forward, mesh_u, mesh_v
        .endm

; Prepares the data of the viewpoint that the ray goes through.  Branches to
; none if there is none, or to missed if the ray goes away from the mesh.
        .macro  begin_screen_bounds none, missed
        load_part mesh_table, MESH_FIRST, 2, t1, t0 ; also t2: their number
        IBXEQ   t2, r0, r0, \none
        copy_three ox, oy, oz, t3, t4, t5
        .if     CASTS_SHADOWS
        IBXNE   mesh_stops, r0, r0, viewpoint_light\@
        .if     ORIGINS_DIFFER
        BIM     \none
        .else
        IBXEQ   level, r0, first_level, viewpoint_position\@
        BIM     \none
        .endif
viewpoint_light\@:
        EX      t0, shadow_limit
        LOD     [t0, index_one], t0
        IBXEQ   t0, r0, r0, \none
        load_from t0, 3, t3
viewpoint_position\@:
        .endif
        SHIFTI  t1, 6, t1
        ADDX    mesh_table, t1, node_at
viewpoint_compare\@:
        RTOR    node_at, t0
        load_from t0, VIEWPOINT_SIZE, viewpoint_x
        CFPNE   viewpoint_x, t3, viewpoint_differs\@
        CFPNE   viewpoint_y, t4, viewpoint_differs\@
        CFPEQ   viewpoint_z, t5, viewpoint_found\@
viewpoint_differs\@:
        IX      node_at, 64 * VIEWPOINT_SIZE
        IX      t2, -1
        IBXNE   t2, r0, r0, viewpoint_compare\@
        BIM     \none
viewpoint_found\@:
        IBXEQ   mesh_stops, r0, r0, viewpoint_near\@
        CFPLT   viewpoint_far, tin, \none
viewpoint_near\@:
        IBXEQ   viewpoint_axis, r0, r0, viewpoint_axis_x\@
        IBXEQ   viewpoint_axis, r0, index_one, viewpoint_axis_y\@
        viewpoint_axes dz, dx, dy
        BIM     viewpoint_turned\@
viewpoint_axis_x\@:
        viewpoint_axes dx, dy, dz
        BIM     viewpoint_turned\@
viewpoint_axis_y\@:
        viewpoint_axes dy, dz, dx
viewpoint_turned\@:
        MPYS    mesh_forward, viewpoint_sign, mesh_forward
        IBXNE   mesh_stops, r0, r0, viewpoint_to_light\@
        CFPLT   r0, mesh_forward, viewpoint_ahead\@
        BIM     \missed
viewpoint_to_light\@:
        CFPGE   mesh_forward, r0, \missed
viewpoint_ahead\@:
        DIVS    one, mesh_forward, t0
        ABS     mesh_forward, mesh_forward
        MPYS    mesh_u, t0, mesh_u
        MPYS    mesh_v, t0, mesh_v
        SHIFTI  viewpoint_bounds, 6, mesh_bounds
        ADDX    mesh_table, mesh_bounds, mesh_bounds
        ES      signs, 0                        ; one order for all rays
        .endm

        .macro  near_screen_bounds box_missed
        .rept   5
        LOD     [node_at], window\+
        IX      node_at, 64
        .endr
        MPYS    tin, mesh_forward, high_z
        CFPLT   mesh_u, window0, \box_missed
        CFPLT   window1, mesh_u, \box_missed
        CFPLT   mesh_v, window2, \box_missed
        CFPLT   window3, mesh_v, \box_missed
        CFPGE   window4, high_z, \box_missed
        .endm

