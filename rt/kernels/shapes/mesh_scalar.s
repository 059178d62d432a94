; mesh_scalar.s - intersects one ray with a mesh: triangles in a hierarchy of
; bounding boxes.
;
;       CALL MESH (RAY, PRIMITIVE, SEGMENT)
;
; The arguments are those of sphere_scalar.s, the method is that of
; mesh_vector.s.  The offset of the hit triangle in the table is stored in
; P_PATCH_POINT.  For a ray to a light (RAY = SHADOW_RAY) SEGMENT is any hit
; before the limit in SHADOW_LIMIT; the point where the ray ends follows it.

        include_form lanes

        .share  local
        .regs   r79, mesh_table, mesh_row, node, node_at, signs, hit_link
        .regs   r85, axis_x, axis_y, axis_z             ; the ray's axes, 0-2
        .regs   r88, local_ox, local_oy, local_oz, shear_x, shear_y, local_z
        .regs   r94, inverse_x, inverse_y, inverse_z, size_x, size_y, size_z
        .regs   r100, box_x, box_y, box_z, box_hx, box_hy, box_hz
        .regs   r106, low_x, low_y, low_z, high_x, high_y, high_z
        .regs   r112, mesh_less, mesh_zero, triangle, triangles_left, nearest_side
        .regs   r117, side_x0, side_y0, side_z0, side_x1, side_y1, side_z1
        .regs   r123, side_x2, side_y2, side_z2, side_u, side_v, side_w
        .regs   r129, triangle_at, mesh_least, mesh_stops
        .endshare
        .regs   box_x, box0, box1, box2, box3, box4, box5
        .equ    MESH_REGISTERS, 100

        .data
mesh_numbers:   .word 0.99999999999909050529   ; bound_less
                .word 1e-60
mesh_save:      .space MESH_REGISTERS
        .code

        .macro  local_axes kx, ky, kz, x, y, z
        ES      axis_x, \kx
        ES      axis_y, \ky
        ES      axis_z, \kz
        copy_three o\x, o\y, o\z, local_ox, local_oy, local_oz
        DIVS    one, d\z, local_z
        MPYS    d\x, local_z, shear_x
        MPYS    d\y, local_z, shear_y
        .endm

        .macro  begin_axis d, sign, inverse, size
        RTOR    \d, t0
        CFPNE   t0, r0, axis_slanted\@
        RTOR    mesh_zero, t0
axis_slanted\@:
        DIVS    one, t0, \inverse
        ABS     \inverse, \size
        CFPGE   \d, r0, axis_above\@
        IX      signs, 2 * \sign
axis_above\@:
        .endm

        .macro  greater a, b
        CFPGE   \a, \b, greater\@
        RTOR    \b, \a
greater\@:
        .endm

        .macro  lesser a, b
        CFPGE   \b, \a, lesser\@
        RTOR    \b, \a
lesser\@:
        .endm

; Loads the corners of the triangle at triangle_at along one of the ray's own
; axes, not yet relative to its origin.
        .macro  load_corners axis, c0, c1, c2
        LOD     [triangle_at, \axis], \c0
        ADDX    \axis, t0, t1
        LOD     [triangle_at, t1], \c1
        ADDX    t1, t0, t1
        LOD     [triangle_at, t1], \c2
        .endm

        .macro  from_origin o, c0, c1, c2
        SUBN    \c0, \o, \c0
        SUBN    \c1, \o, \c1
        SUBN    \c2, \o, \c2
        .endm

; Prepares the data of the ray for a traversal: its own axes and signs.
        .macro  begin_mesh
        FLR     sh0, mesh_row
        address_of a_primitive, P_TABLE, t0
        LOD     [t0], mesh_table
        load_words mesh_numbers, 2, mesh_less, t0
        EX      hit_link, MESH_LEAF_HIT
        ABS     dx, t0
        ABS     dy, t1
        ABS     dz, t2
        CFPLT   t0, t1, mesh_not_x\@
        CFPLT   t0, t2, mesh_z\@
        local_axes 1, 2, 0, y, z, x
        BIM     mesh_turned\@
mesh_not_x\@:
        CFPLT   t1, t2, mesh_z\@
        local_axes 2, 0, 1, z, x, y
        BIM     mesh_turned\@
mesh_z\@:
        local_axes 0, 1, 2, x, y, z
mesh_turned\@:
        ES      signs, 0
        begin_axis dx, 1, inverse_x, size_x
        begin_axis dy, 2, inverse_y, size_y
        begin_axis dz, 4, inverse_z, size_z
        RTOR    big, tin
        .endm

; A ray to a light ends at the first triangle that it hits before the light
; (mesh_stops = 1).  A hit at its limit does not count.
        .macro  begin_limit
        ES      mesh_stops, 0
        RTOR    hit_link, nearest_side          ; after all triangles
        .if     CASTS_SHADOWS
        EX      t0, shadow_ray
        IBXNE   t0, r0, a_ray, limit_none\@
        ES      mesh_stops, 1
        RTOR    r0, nearest_side                ; before all triangles
        EX      t0, shadow_limit
        LOD     [t0], tin
limit_none\@:
        .endif
        .endm

; Tests the box of the node at node_at, which advances to its links.  Branches
; to box_missed if the ray misses the box.
        .macro  near_boxes box_missed
        .rept   MESH_LINKS - MESH_BOX
        LOD     [node_at], box\+
        IX      node_at, 64
        .endr
        three   SUBN, box_x, box_y, box_z, ox, oy, oz, box_x, box_y, box_z
        MPYS    box_hx, size_x, box_hx
        MPYS    box_hy, size_y, box_hy
        MPYS    box_hz, size_z, box_hz
        MPYS    box_x, inverse_x, box_x
        MPYS    box_y, inverse_y, box_y
        MPYS    box_z, inverse_z, box_z
        SUBN    box_x, box_hx, low_x
        ADDN    box_x, box_hx, high_x
        SUBN    box_y, box_hy, low_y
        ADDN    box_y, box_hy, high_y
        SUBN    box_z, box_hz, low_z
        ADDN    box_z, box_hz, high_z
        greater low_x, low_y
        lesser  high_x, high_y
        greater low_x, low_z
        lesser  high_x, high_z
        MPYS    low_x, mesh_less, low_x
        CFPLT   high_x, r0, \box_missed
        CFPLT   high_x, low_x, \box_missed
        CFPGE   low_x, tin, \box_missed
        .endm

        .if     MESH_BOXES == 0
        .include "shapes/mesh_screen_bounds_scalar.s"
        .endif

; Traverses the nodes nearer than tin.  sides tests a triangle.  rows is the
; address of the rows, size the words of a row, first the offset of a leaf's
; triangles from the links.
        .macro  walk_mesh sides, bounds=boxes, rows=mesh_table, size=MESH_SIZE, first=MESH_FIRST - MESH_LINKS
        ES      node, \size
mesh_node\@:
        SHIFTI  node, 6, node_at
        ADDX    node_at, \rows, node_at
        near_\bounds mesh_box_missed\@
        LOD     [node_at, signs], node
        IBXLT   node, r0, hit_link, mesh_node\@
        SUBX    node, hit_link, node
        IX      node_at, 64 * (\first)
        load_from node_at, 2, triangle          ; also triangles_left
        BIM     mesh_triangle\@
mesh_box_missed\@:
        IX      node_at, 64
        LOD     [node_at, signs], node
        IBXNE   node, r0, r0, mesh_node\@
        BIM     mesh_walked\@

mesh_triangle\@:
        SHIFTI  triangle, 6, triangle_at
        ADDX    triangle_at, mesh_table, triangle_at
        ES      t0, 3
        load_corners axis_z, side_z0, side_z1, side_z2
        load_corners axis_x, side_x0, side_x1, side_x2
        load_corners axis_y, side_y0, side_y1, side_y2
        from_origin local_oz, side_z0, side_z1, side_z2
        from_origin local_ox, side_x0, side_x1, side_x2
        from_origin local_oy, side_y0, side_y1, side_y2
        three_by MPYS, shear_x, side_z0, side_z1, side_z2, t0, t1, t2
        three_by MPYS, shear_y, side_z0, side_z1, side_z2, t3, t4, t5
        three   SUBN, side_x0, side_x1, side_x2, t0, t1, t2, side_x0, side_x1, side_x2
        three   SUBN, side_y0, side_y1, side_y2, t3, t4, t5, side_y0, side_y1, side_y2
        MPYS    side_x1, side_y2, side_u
        MPYS    side_y1, side_x2, t0
        MPYS    side_x2, side_y0, side_v
        MPYS    side_y2, side_x0, t1
        MPYS    side_x0, side_y1, side_w
        MPYS    side_y0, side_x1, t2
        \sides
        ADDX    triangle, mesh_row, triangle
        IX      triangles_left, -1
        IBXNE   triangles_left, r0, r0, mesh_triangle\@
        IBXNE   node, r0, r0, mesh_node\@
mesh_walked\@:
        .endm

; Computes U, V, W.
        .macro  subtract_sides
        three   SUBN, side_u, side_v, side_w, t0, t1, t2, side_u, side_v, side_w
        .endm

; Keeps the nearest hit in tin and nearest_side.
        .macro  nearest_sides
        subtract_sides
        CFPLT   side_u, r0, mesh_all_below\@
        CFPLT   side_v, r0, mesh_not_above\@
        CFPGE   side_w, r0, mesh_side\@
mesh_not_above\@:
        CFPLT   r0, side_u, mesh_next\@
mesh_all_below\@:
        CFPLT   r0, side_v, mesh_next\@
        CFPLT   r0, side_w, mesh_next\@
mesh_side\@:
        three   MPYS, side_u, side_v, side_w, side_z0, side_z1, side_z2, t0, t1, t2
        ADDN    side_u, side_v, t3
        ADDN    t0, t1, t0
        ADDN    t3, side_w, t3
        ADDN    t0, t2, t0
        CFPEQ   t3, r0, mesh_next\@
        MPYS    t0, local_z, t0
        DIVS    t0, t3, t0
        CFPGE   mesh_least, t0, mesh_next\@
        CFPLT   tin, t0, mesh_next\@
        CFPNE   t0, tin, mesh_nearer\@
        IBXGE   triangle, r0, nearest_side, mesh_next\@
mesh_nearer\@:
        RTOR    t0, tin
        RTOR    triangle, nearest_side
        IBXNE   mesh_stops, r0, r0, mesh_hit
mesh_next\@:
        .endm

        .kernel mesh
mesh:
        enter_solver 1, mesh_save, MESH_REGISTERS
        RTOR    lower, mesh_least
        begin_mesh
        begin_limit
        .if     MESH_BOXES == 0
        begin_screen_bounds mesh_boxes, mesh_missed
        walk_mesh nearest_sides, screen_bounds, mesh_bounds, SCREEN_SIZE, SCREEN_FIRST - SCREEN_LINKS
        BIM     mesh_walk_done
        .endif
mesh_boxes:
        walk_mesh nearest_sides
mesh_walk_done:
        IBXEQ   nearest_side, r0, r0, mesh_missed
        CFPGE   tin, big, mesh_missed
mesh_hit:
        RTOR    tin, tout
        IX      a_primitive, 64 * P_PATCH_POINT
        STO     [a_primitive], nearest_side
        STO     [a_primitive, index_one], r0
        leave_solver mesh_save, MESH_REGISTERS
mesh_missed:
        miss_near mesh_save, MESH_REGISTERS
        .endkernel

        .if     MESH_CROSSINGS
        .include "shapes/mesh_crossings_scalar.s"
        .endif
