; mesh_screen_bounds_vector.s - tests a queue of rays against the windows of a
; mesh if they all go through one viewpoint: a camera or a light.  From there
; the mesh is seen as windows (rt/bvh/screen_bounds.h), which replace the
; boxes.
;
; The choice depends on the ray alone and not on its queue, because the results
; can differ: if the viewpoint is in the plane of a triangle, rounding decides
; whether it is hit, and a window may exclude a ray that a box admits.
;
; For a ray, in the order of the viewpoint's axes, with g = sign dw:
;
;   u = du / g    v = dv / g    z = |g| t
;
; where t is measured from the viewpoint.  A ray to a light starts at
; z = |g| (limit + k_shadow), and no hit in its first k_shadow counts.
;
; These macros are a part of mesh_vector.s.  The traversing rays have u, v, |g|
; in the registers of their origin, instead of origin, 1/d and 1/|d|.
; Source: rt/bvh/screen_bounds.h.

        .reg    mesh_u, mesh_ox
        .reg    mesh_v, mesh_oy
        .reg    mesh_forward, mesh_oz           ; |g|
        .share  hits
        .reg    mesh_viewpoint, r167            ; address of the viewpoint's row
        .endshare

; Finds the viewpoint that the near rays go through, or branches to none.
        .macro  find_viewpoint none
        RTOR    shadows, s0
        if_to_point viewpoint_position\@, s1
        IBXNE   shadows, r0, r0, \none
        IBXEQ   from_one_point, r0, r0, \none
        EX      s0, queue_origin
viewpoint_position\@:
        load_from s0, 3, s1                     ; the point
        load_part mesh_table, MESH_FIRST, 2, s4, s0 ; also s5: their number
        SHIFTI  s4, 6, s4
        ADDX    mesh_table, s4, mesh_viewpoint
        BIM     viewpoint_next\@
viewpoint_compare\@:
        RTOR    mesh_viewpoint, s0
        load_from s0, 3, s6
        CFPNE   s6, s1, viewpoint_differs\@
        CFPNE   s7, s2, viewpoint_differs\@
        CFPEQ   s8, s3, viewpoint_found\@
viewpoint_differs\@:
        IX      mesh_viewpoint, 64 * VIEWPOINT_SIZE
viewpoint_next\@:
        IBXNE   s5, minus_one_index, minus_one_index, viewpoint_compare\@, s5
        BIM     \none
viewpoint_found\@:
        .endm

; s2, s3, s4 = the directions along the viewpoint's axes w, u, v; s5, s6, s7 =
; VIEWPOINT_AXIS and the next two words.
        .macro  viewpoint_axes
        load_part mesh_viewpoint, VIEWPOINT_AXIS, 3, s5, s0
        copy_three dx, dy, dz, s2, s3, s4
        IBXEQ   s5, r0, r0, viewpoint_turned\@
        copy_three dy, dz, dx, s2, s3, s4
        IBXEQ   s5, r0, one_index, viewpoint_turned\@
        copy_three dz, dx, dy, s2, s3, s4
viewpoint_turned\@:
        .endm

; Starts the rays that go towards the mesh at the first node, except rays to a
; light from far away.  Branches to none if there are none.
        .macro  start_screen_bounds none
        set_mesh_rays
        viewpoint_axes
        three_by VXTOV, [mesh_ray], [s2], [s3], [s4], [mesh_forward], [mesh_u], [mesh_v]
        MPYSV   [mesh_forward], s6, [mesh_forward]
        CMPLTV  r0, [mesh_forward], [mesh_bits]
        IBXEQ   shadows, r0, r0, screen_bounds_tested\@
        CMPLTV  [mesh_forward], r0, [mesh_bits]
        VXTOV   [mesh_ray], [near_limit], [mesh_limit]
        keep_where CMPGEV, s7, [mesh_limit], mesh_bits, mesh_hit
screen_bounds_tested\@:
        if_none mesh_bits, m, \none
        walk_keep mesh_ray
        walk_keep mesh_u
        walk_keep mesh_v
        walk_keep mesh_forward
        set_walk
        DIVSV   one, [mesh_forward], [mesh_g0]
        MPYSV   [mesh_u], [mesh_g0], [mesh_u]
        MPYSV   [mesh_v], [mesh_g0], [mesh_v]
        ABSV    [mesh_forward], [mesh_forward]
        limit_screen_bounds near_limit
        ES      s2, SCREEN_SIZE
        VTOV    s2, [mesh_at]
        load_of mesh_viewpoint, VIEWPOINT_BOUNDS, s0
        SHIFTI  s0, 6, s0
        ADDX    mesh_table, s0, mesh_links
        IX      mesh_links, 64 * SCREEN_LINKS
        .endm

; Prepares the rays that use boxes instead, or branches to none if there are
; none.
        .macro  find_far none
        IBXEQ   shadows, r0, r0, \none
        load_of mesh_viewpoint, VIEWPOINT_FAR, s0
        CMPLTV  s0, [near_limit], [bits0]
        if_none bits0, s0, \none
        RTOR    near, m
        set_walk
        address_of mesh_table, MESH_LINKS, mesh_links
        .endm

; Keeps these rays among the placed ones, if there is a viewpoint.
        .macro  among_far
        IBXEQ   mesh_viewpoint, r0, r0, far_placed\@
        load_of mesh_viewpoint, VIEWPOINT_FAR, s2
        CMPLTV  s2, [mesh_limit], [mesh_bits]
        CNTOB   [mesh_bits], m
        walk_keep mesh_ray
        walk_keep mesh_limit
        set_walk
far_placed\@:
        .endm

        .macro  screen_bounds_below least, greatest
        keep_where CMPGEV, \greatest, \least, mesh_bits, mesh_hit
        .endm

; Gathers the next word of the windows.
        .macro  screen_bounds_word
        VXTOV   [mesh_at], [s0], [mesh_g0]
        IX      s0, 64
        .endm

        .macro  step_screen_bounds
        address_of mesh_links, -SCREEN_LINKS, s0
        screen_bounds_word
        CMPGEV  [mesh_u], [mesh_g0], [mesh_bits]
        screen_bounds_word
        screen_bounds_below [mesh_u], [mesh_g0]
        screen_bounds_word
        screen_bounds_below [mesh_g0], [mesh_v]
        screen_bounds_word
        screen_bounds_below [mesh_v], [mesh_g0]
        screen_bounds_word
        keep_where CMPLTV, [mesh_g0], [mesh_limit], mesh_bits, mesh_hit
        ADDXV   [mesh_at], one_index, [mesh_at] ?! [mesh_bits]
        VXTOV   [mesh_at], [s0], [mesh_g1]
        .endm

        .macro  keep_screen_bounds
        .rept   5
        walk_keep walk\+
        .endr
        walk_keep mesh_limit
        .endm

        .macro  limit_screen_bounds limits
        VXTOV   [mesh_ray], [\limits], [mesh_limit]
        MPYSV   [mesh_limit], [mesh_forward], [mesh_limit]
        .endm

