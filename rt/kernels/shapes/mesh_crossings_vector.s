; mesh_crossings_vector.s - computes all crossings of a queue of rays with a
; mesh, for Boolean trees and for meshes that transmit light.
;
; The rays traverse as in mesh_vector.s, but no triangle ends a traversal.  A
; line has an even number of crossings with a closed mesh only if each counts
; once, also at an edge or a corner.  Therefore a plane through the ray cuts the
; triangles.  With the corners P as there, the ray at the origin, and "above"
; for y >= 0:
;
;   an edge from a below to b above crosses y = 0 to the right
;       if  ax by >= ay bx
;   a triangle is crossed if two of its edges cross y = 0, and exactly one of
;       them to the right
;
; Nothing else about an edge matters, and all its triangles evaluate it in the
; same order, from below.  The plane cuts each triangle in two of its edges or
; in none, so it cuts a closed mesh in closed lines of edges.  On such a line
; the side changes an even number of times, independently of rounding.  With U,
; V, W as there:
;
;   t = (|U| z0 + |V| z1 + |W| z2) / dz / (|U| + |V| + |W|)
;
; U, V, W have one sign, unless rounding decides; if all are 0, t = z0 / dz.
;
; Each crossing is appended to its ray's list.  If several pairs of one ray
; cross in the same step, the last store wins and the other pairs are stored in
; further passes.  Lists are columns: one for the first crossings of all rays,
; one for the second, and so on.  The triangles are in as many columns again,
; after the reserved ones.  At the end exchanges of neighbouring columns sort
; the lists.
;
; mesh_crossings: the crossings beyond lower and up to 2 k_delta
;   beyond near_limit; those farther away are not visible.
; mesh_solid, mesh_body: the crossings with the mesh or with its body beyond the
;   ray's start, or beyond lower if that is less.  The ray starts inside if
;   their number is odd: then the first is minus_big.
;
; In:  ox oy oz dx dy dz lower near_limit, near long; the primitive's record and
;      table.
; Out: from tin on, columns of crossings, ascending; at equal distance the first
;      triangle comes first.  After the last is big, or minus_big at the end of
;      a segment.  P_EVENTS or, for solids, P_SEGMENTS is the number of columns
;      or segments; a solid without P_STATE_KERNEL also gets P_EVENTS.
; Source: the side rule: crossings of a polygon, textbook; that the crossings of
; a mesh are even independently of rounding, and the lists: derived here.

        .share  hits
        .reg    mesh_counts, r167               ; crossings per ray, integers
        .endshare

; The vectors of pairs are those of mesh_vector.s, with bits for the corners.
        .share  scratch
        .regs   r251, side_b0, side_b1, side_b2
        .endshare
        .equ    CROSSING_VECTORS, SIDE_VECTORS + 3

; Data of the mesh, in the registers of its shape.
        .share  shape
        .regs   r40, mesh_is_solid, mesh_capacity, triangles_at
        .endshare

        .data
crossing_bases:
        vector_bases SIDE_VECTORS - 3, side_store, 6, crossing_bits
crossing_bits:  .space 6 * QUEUE_BIT_WORDS
        .align  64
mesh_count_store: .space QUEUE
odd_store:      .space 2 * QUEUE
        .code

        .macro  set_crossing_sides count
        set_lengths \count, m_high, crossing_bases, lane_descriptors, CROSSING_VECTORS, side_ray
        .endm

; Changes [side_bits] in the lanes in which the edge from a to b crosses y = 0
; to the right.  [into], [side_g0] = ax by, ay bx; then [into] = their
; difference.
        .macro  cross_edge above_a, above_b, ax, ay, bx, by, into
        MPYSV   [\ax], [\by], [\into]
        MPYSV   [\ay], [\bx], [side_g0]
        ANDNB   [\above_b], [\above_a], [side_more]
        side_and side_more, [\into], [side_g0]
        XORB    [side_bits], [side_more], [side_bits]
        ANDNB   [\above_a], [\above_b], [side_more]
        side_and side_more, [side_g0], [\into]
        XORB    [side_bits], [side_more], [side_bits]
        SUBNV   [\into], [side_g0], [\into]
        .endm

; Advances to the next column, of crossings or of triangles.
        .macro  next_list_column column
        EX      s0, 64 * CROSSING_SIZE
        ADDX    \column, s0, \column
        .endm

; Exchanges [a] and [b] in the lanes of [bits0].
        .macro  swap_columns a, b
        VTOV    [\a], [w0]
        VTOV    [\b], [\a] ? [bits0]
        VTOV    [w0], [\b] ? [bits0]
        .endm

        .kernel mesh
mesh_crossings:
        ES      mesh_is_solid, 0
        load_word k_delta, s0
        ADDN    s0, s0, s0
        ADDNV   [near_limit], s0, [w9]
        BIM     crossings_begin
mesh_body:
        ES      mesh_is_solid, 1
        VTOV    big, [w9]
        load_record P_SHAPE + 2, 2, s2          ; offset and room of the body
        FLR     s2, s2
        SHIFTI  s2, 6, s2
        load_record P_TABLE, 2, mesh_table
        ADDX    mesh_table, s2, mesh_table
        BIM     crossings_capacity
mesh_solid:
        ES      mesh_is_solid, 1
        VTOV    big, [w9]
crossings_begin:
        load_field P_SHAPE + 1, s3
        load_record P_TABLE, 2, mesh_table      ; also mesh_row
crossings_capacity:
        FLR     mesh_row, mesh_row
        FLR     s3, mesh_capacity
        EX      s0, 64 * CROSSING_SIZE
        MPYX    mesh_capacity, s0, mesh_capacity
        ADDX    tin, mesh_capacity, triangles_at
        begin_mesh
        describe mesh_counts, mesh_count_store, near
        ES      s0, 0
        VTOV    s0, [mesh_counts]
        start_walk w9
        walk_mesh intersect_every, 0

; Adds minus_big to the lists with an odd number of crossings.
        IBXEQ   mesh_is_solid, r0, r0, crossings_fill
        ANDV    [mesh_counts], one_index, [w0]
        CMPNEV  [w0], r0, [bits0]
        if_none bits0, s0, crossings_fill
        EX      s2, odd_store
        EX      s3, odd_store + 64 * QUEUE
        CPSV    [iota], [s2] ? [bits0]
        CPSV    [mesh_counts], [s3] ? [bits0]
        EX      s4, CROSSING_SIZE
        MPYLV   [s3], s4, [s3]
        ADDXV   [s2], [s3], [s2]
        VTOVX   [s2], minus_big, [tin]
        VTOVX   [s2], r0, [triangles_at]
        ADDXV   [mesh_counts], one_index, [mesh_counts] ? [bits0]

; Fills the ends of the lists.  s2 = the number of columns in use.
crossings_fill:
        ES      s2, 0
        RTOR    tin, s3
        RTOR    triangles_at, s4
crossings_column:
        CMPLTV  s2, [mesh_counts], [bits0]
        if_none bits0, s0, crossings_filled
        IBXEQ   s0, r0, near, crossings_full
        VTOV    big, [s3] ?! [bits0]
        VTOV    r0, [s4] ?! [bits0]
crossings_full:
        next_list_column s3
        next_list_column s4
        IX      s2, 1
        BIM     crossings_column
crossings_filled:
        IBXNE   s2, r0, r0, crossings_order
        VTOV    big, [tin]
        VTOV    r0, [triangles_at]
        ES      s2, 1
        IBXEQ   mesh_is_solid, r0, r0, crossings_count
        next_list_column s3
        next_list_column s4
        VTOV    minus_big, [s3]
        VTOV    r0, [s4]
        ES      s2, 2
        BIM     crossings_count

; Moves each column back to its place among the previous ones.
crossings_order:
        ES      s3, 1
        RTOR    tin, s4
crossings_next:
        IBXEQ   s3, r0, s2, crossings_ordered
        next_list_column s4
        RTOR    s4, s6
        RTOR    s3, s9
crossings_before:
        RTOR    s6, s5
        EX      s0, -64 * CROSSING_SIZE
        ADDX    s5, s0, s5
        ADDX    s5, mesh_capacity, s7
        ADDX    s6, mesh_capacity, s8
        CMPLTV  [s6], [s5], [bits0]
        CMPEQV  [s6], [s5], [bits1]
        keep_where CMPLTV, [s8], [s7], bits1, bits2
        ORB     [bits0], [bits1], [bits0]
        if_none bits0, s0, crossings_placed
        swap_columns s5, s6
        swap_columns s7, s8
        RTOR    s5, s6
        IBXNE   s9, minus_one_index, r0, crossings_before, s9
crossings_placed:
        IX      s3, 1
        BIM     crossings_next

; Sets the unused segments to misses.
crossings_ordered:
        IBXEQ   mesh_is_solid, r0, r0, crossings_count
        RTOR    tin, s3
        ES      s4, 0
crossings_segment:
        CMPGEV  [s3], big, [bits0]
        next_list_column s3
        VTOV    minus_big, [s3] ? [bits0]
        next_list_column s3
        IX      s4, 2
        IBXNE   s4, r0, s2, crossings_segment

crossings_count:
        IBXEQ   mesh_is_solid, r0, r0, crossings_store
        SHIFTI  s2, -1, s3
        store_field P_SEGMENTS, s3
        load_field P_STATE_KERNEL, s0
        IBXNE   s0, r0, r0, crossings_stored
crossings_store:
        store_field P_EVENTS, s2
crossings_stored:
        BIM     0, link_kernel

; Tests the mesh_pairs pairs and appends their crossings.
intersect_every:
        set_crossing_sides mesh_pairs
        ES      mesh_pairs, 0
        take_corners
        CMPGEV  [side_y0], r0, [side_b0]
        CMPGEV  [side_y1], r0, [side_b1]
        CMPGEV  [side_y2], r0, [side_b2]
        XORB    [side_bits], [side_bits], [side_bits]
        cross_edge side_b1, side_b2, side_x1, side_y1, side_x2, side_y2, side_u
        cross_edge side_b2, side_b0, side_x2, side_y2, side_x0, side_y0, side_v
        cross_edge side_b0, side_b1, side_x0, side_y0, side_x1, side_y1, side_w
        if_none side_bits, s2, every_hit
        keep_sides
        set_crossing_sides s2
        ABSV    [side_u], [side_u]
        ABSV    [side_v], [side_v]
        ABSV    [side_w], [side_w]
        ADDNV   [side_u], [side_v], [side_x0]
        ADDNV   [side_x0], [side_w], [side_x0]
        CMPEQV  [side_x0], r0, [side_bits]
        VTOV    one, [side_u] ? [side_bits]
        VTOV    one, [side_x0] ? [side_bits]
        weigh_corners
        of_ray  w5, side_g1
        MPYSV   [side_z0], [side_g1], [side_z0]
        DIVSV   [side_z0], [side_x0], [side_z0] ; t
        IBXNE   mesh_is_solid, r0, r0, every_ahead
        of_ray  lower, side_g1
        CMPLTV  [side_g1], [side_z0], [side_bits]
        of_ray  w9, side_g1
        side_and side_bits, [side_g1], [side_z0]
        BIM     every_counted
every_ahead:
        .if     INTERIORS
        load_word passed_current, s0
        IBXNE   s0, r0, r0, every_passed
        .endif
        CMPLTV  r0, [side_z0], [side_bits]
every_counted:
        if_none side_bits, s3, every_hit
        IBXEQ   s3, r0, s2, every_turn
        RTOR    s3, s2
every_keep:
        keep_hits
        set_crossing_sides s2
every_turn:
        VXTOV   [side_ray], [mesh_counts], [side_x0]
        EX      s3, CROSSING_SIZE
        MPYLV   [side_x0], s3, [side_x1]
        ADDXV   [side_x1], [side_ray], [side_x1]
        VTOVX   [side_x1], [side_z0], [tin]
        VTOVX   [side_x1], [side_triangle], [triangles_at]
        ADDXV   [side_x0], one_index, [side_x0]
        VTOVX   [side_ray], [side_x0], [mesh_counts]
        VXTOV   [side_x1], [triangles_at], [side_x2]
        CMPNEV  [side_x2], [side_triangle], [side_bits]
        CNTOB   [side_bits], s2
        IBXNE   s2, r0, r0, every_keep
every_hit:
        BIM     0, lane_link
        .if     INTERIORS
every_passed:
        of_ray  lower, side_g1
        CMPLTV  [side_g1], r0, [side_bits]
        VTOV    r0, [side_g1] ?! [side_bits]
        CMPLTV  [side_g1], [side_z0], [side_bits]
        BIM     every_counted
        .endif
        .endkernel
