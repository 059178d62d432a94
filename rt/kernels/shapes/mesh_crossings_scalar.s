; mesh_crossings_scalar.s - computes all crossings of one ray with a mesh.
;
;       CALL MESH_CROSSINGS (RAY, PRIMITIVE, CROSSINGS)
;       CALL MESH_SOLID (RAY, PRIMITIVE, SEGMENTS)
;       CALL MESH_BODY (RAY, PRIMITIVE, SEGMENTS)
;
; The arguments are those of sphere_scalar.s, the method is that of
; mesh_crossings_vector.s.  CROSSINGS receives the crossings beyond the ray's
; lower limit, ascending; SEGMENTS receives the segments of the ray inside, from
; its start on.  Their number is stored in P_EVENTS or P_SEGMENTS.  The
; triangles of the crossings are stored after the words reserved for the
; crossings.

        .share  local
        .regs   r131, mesh_crossed, sorted_count, sorted_triangles, sorted_at
        .reg    sorted_before, r135
        .regs   r136, sorted_t, sorted_triangle
        .if     INTERIORS
        .reg    mesh_is_solid, r138
        .equ    MESH_CROSSING_REGISTERS, 107
        .else
        .equ    MESH_CROSSING_REGISTERS, 106
        .endif
        .endshare

        .data
crossings_save: .space MESH_CROSSING_REGISTERS
        .code

; Changes the side if the edge from a to b crosses y = 0 to the right.  product,
; other = ax by, ay bx.
        .macro  cross_edge ya, yb, product, other
        CFPGE   \ya, r0, edge_from_above\@
        CFPLT   \yb, r0, edge_crossed\@
        CFPLT   \product, \other, edge_crossed\@
        BIM     edge_changes\@
edge_from_above\@:
        CFPGE   \yb, r0, edge_crossed\@
        CFPLT   \other, \product, edge_crossed\@
edge_changes\@:
        XOR     mesh_crossed, index_one, mesh_crossed
edge_crossed\@:
        .endm

; Inserts the crossing t0 and its triangle into the sorted list.
        .macro  list_crossing
        RTOR    sorted_count, sorted_at
        IX      sorted_count, 1
list_next\@:
        IBXEQ   sorted_at, r0, r0, list_here\@
        ADDX    sorted_at, sorted_before, t1
        LOD     [a_segment, t1], sorted_t
        LOD     [sorted_triangles, t1], sorted_triangle
        CFPLT   sorted_t, t0, list_here\@
        CFPNE   sorted_t, t0, list_after\@
        IBXLT   sorted_triangle, r0, triangle, list_here\@
list_after\@:
        STO     [a_segment, sorted_at], sorted_t
        STO     [sorted_triangles, sorted_at], sorted_triangle
        RTOR    t1, sorted_at
        BIM     list_next\@
list_here\@:
        STO     [a_segment, sorted_at], t0
        STO     [sorted_triangles, sorted_at], triangle
        .endm

        .macro  every_side
        ES      mesh_crossed, 0
        cross_edge side_y1, side_y2, side_u, t0
        cross_edge side_y2, side_y0, side_v, t1
        cross_edge side_y0, side_y1, side_w, t2
        IBXEQ   mesh_crossed, r0, r0, side_not\@
        subtract_sides
        ABS     side_u, side_u
        ABS     side_v, side_v
        ABS     side_w, side_w
        ADDN    side_u, side_v, t3
        ADDN    t3, side_w, t3
        CFPNE   t3, r0, side_wide\@
        RTOR    one, side_u
        RTOR    one, t3
side_wide\@:
        three   MPYS, side_u, side_v, side_w, side_z0, side_z1, side_z2, t0, t1, t2
        ADDN    t0, t1, t0
        ADDN    t0, t2, t0
        MPYS    t0, local_z, t0
        DIVS    t0, t3, t0
        CFPGE   mesh_least, t0, side_not\@
        list_crossing
side_not\@:
        .endm

; For a solid, crossings count beyond the start, or beyond lower if that is
; less.
        .macro  from_start
        RTOR    r0, mesh_least
        .if     INTERIORS
        ES      mesh_is_solid, 1
        CFPGE   lower, r0, from_start\@
        RTOR    lower, mesh_least
from_start\@:
        .endif
        .endm

; Starts an empty list; the triangles are stored after room words.
        .macro  begin_crossings room
        FLR     \room, sorted_triangles
        SHIFTI  sorted_triangles, 6, sorted_triangles
        ADDX    a_segment, sorted_triangles, sorted_triangles
        ES      sorted_before, -1
        ES      sorted_count, 0
        .endm

        .kernel mesh
mesh_crossings:
        enter_solver 2, crossings_save, MESH_CROSSING_REGISTERS
        RTOR    lower, mesh_least
        .if     INTERIORS
        ES      mesh_is_solid, 0
        .endif
        BIM     crossings_begin
mesh_body:
        enter_solver 4, crossings_save, MESH_CROSSING_REGISTERS
        from_start
        FLR     sh2, sorted_at
        SHIFTI  sorted_at, 6, sorted_at
        begin_crossings sh3
        begin_mesh
        ADDX    mesh_table, sorted_at, mesh_table
        BIM     crossings_walk
mesh_solid:
        enter_solver 2, crossings_save, MESH_CROSSING_REGISTERS
        from_start
crossings_begin:
        begin_crossings sh1
        begin_mesh
crossings_walk:
        walk_mesh every_side
        .if     INTERIORS
        IBXNE   mesh_is_solid, r0, r0, crossings_solid
        .else
        CFPEQ   mesh_least, r0, crossings_solid
        .endif
        IBXNE   sorted_count, r0, r0, crossings_any
        STO     [a_segment], big
        ES      sorted_count, 1
crossings_any:
        IX      a_primitive, 64 * P_EVENTS
        STO     [a_primitive], sorted_count
        leave_segments crossings_save, MESH_CROSSING_REGISTERS
crossings_solid:
        IBXNE   sorted_count, r0, r0, solid_hit
        STO     [a_segment], big
        STO     [a_segment, index_one], minus_big
        ES      sorted_count, 2
solid_hit:
        AND     sorted_count, index_one, t2
        IBXEQ   t2, r0, r0, solid_even
        RTOR    minus_big, t0
        RTOR    r0, triangle
        list_crossing
solid_even:
        SHIFTI  sorted_count, -1, t2
        IX      a_primitive, 64 * P_SEGMENTS
        STO     [a_primitive], t2
        IX      a_primitive, 64 * (P_STATE_KERNEL - P_SEGMENTS)
        LOD     [a_primitive], t0
        IBXNE   t0, r0, r0, crossings_stored
        IX      a_primitive, 64 * (P_EVENTS - P_STATE_KERNEL)
        STO     [a_primitive], sorted_count
crossings_stored:
        leave_segments crossings_save, MESH_CROSSING_REGISTERS
        .endkernel
