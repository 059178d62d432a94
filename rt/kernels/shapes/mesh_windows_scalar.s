; mesh_windows_scalar.s - tests one ray against the windows of a mesh if the ray
; goes through a viewpoint.  The formulas are those of mesh_windows_vector.s.  A
; ray that is not a shadow ray goes through a viewpoint if its origin is one.

        .reg    mesh_u, inverse_x
        .reg    mesh_v, inverse_y
        .reg    mesh_forth, inverse_z
        .reg    mesh_windows, size_x
; The viewpoint, in the registers of the boxes until the traversal begins.
        .share  local
        .regs   r100, eye_x, eye_y, eye_z, eye_axis, eye_sign, eye_far, eye_windows
        .endshare

        .macro  eye_axes w, u, v
        RTOR    \w, mesh_forth
        RTOR    \u, mesh_u
        RTOR    \v, mesh_v
        .endm

; Prepares the data of the viewpoint that the ray goes through.  Branches to
; none if there is none, or to missed if the ray goes away from the mesh.
        .macro  begin_windows none, missed
        RTOR    mesh_table, t0
        IX      t0, 64 * MESH_FIRST
        ELEN    t0, 2
        SWAP    [t0], t1, [r0]                  ; also t2: their number
        IBXEQ   t2, r0, r0, \none
        RTOR    ox, t3
        RTOR    oy, t4
        RTOR    oz, t5
        .if     CASTS_SHADOWS
        IBXNE   mesh_stops, r0, r0, eye_light\@
        .if     EYES_APART
        BIM     \none
        .else
        IBXEQ   level, r0, first_level, eye_place\@
        BIM     \none
        .endif
eye_light\@:
        EX      t0, shadow_limit
        LOD     [t0, index_one], t0
        IBXEQ   t0, r0, r0, \none
        ELEN    t0, 3
        SWAP    [t0], t3, [r0]
eye_place\@:
        .endif
        SHIFTI  t1, 6, t1
        ADDX    mesh_table, t1, node_at
eye_look\@:
        RTOR    node_at, t0
        ELEN    t0, EYE_SIZE
        SWAP    [t0], eye_x, [r0]
        CFPNE   eye_x, t3, eye_other\@
        CFPNE   eye_y, t4, eye_other\@
        CFPEQ   eye_z, t5, eye_found\@
eye_other\@:
        IX      node_at, 64 * EYE_SIZE
        IX      t2, -1
        IBXNE   t2, r0, r0, eye_look\@
        BIM     \none
eye_found\@:
        IBXEQ   mesh_stops, r0, r0, eye_near\@
        CFPLT   eye_far, tin, \none
eye_near\@:
        IBXEQ   eye_axis, r0, r0, eye_first\@
        IBXEQ   eye_axis, r0, index_one, eye_second\@
        eye_axes dz, dx, dy
        BIM     eye_turned\@
eye_first\@:
        eye_axes dx, dy, dz
        BIM     eye_turned\@
eye_second\@:
        eye_axes dy, dz, dx
eye_turned\@:
        MPYS    mesh_forth, eye_sign, mesh_forth
        IBXNE   mesh_stops, r0, r0, eye_to_light\@
        CFPLT   r0, mesh_forth, eye_forth\@
        BIM     \missed
eye_to_light\@:
        CFPGE   mesh_forth, r0, \missed
eye_forth\@:
        DIVS    one, mesh_forth, t0
        ABS     mesh_forth, mesh_forth
        MPYS    mesh_u, t0, mesh_u
        MPYS    mesh_v, t0, mesh_v
        SHIFTI  eye_windows, 6, mesh_windows
        ADDX    mesh_table, mesh_windows, mesh_windows
        ES      signs, 0                        ; one order for all rays
        .endm

        .macro  near_windows beside
        LOD     [node_at], low_x
        IX      node_at, 64
        LOD     [node_at], high_x
        IX      node_at, 64
        LOD     [node_at], low_y
        IX      node_at, 64
        LOD     [node_at], high_y
        IX      node_at, 64
        LOD     [node_at], low_z
        IX      node_at, 64
        MPYS    tin, mesh_forth, high_z
        CFPLT   mesh_u, low_x, \beside
        CFPLT   high_x, mesh_u, \beside
        CFPLT   mesh_v, low_y, \beside
        CFPLT   high_y, mesh_v, \beside
        CFPGE   low_z, high_z, \beside
        .endm

