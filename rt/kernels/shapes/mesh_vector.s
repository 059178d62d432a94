; mesh_vector.s - intersects a queue of rays with a mesh: triangles in a
; hierarchy of bounding boxes.
;
; Each ray traverses the hierarchy by itself, and all rays advance one step at a
; time.  A node is identified by its offset; its contents are gathered.  Its
; links give the next node, chosen by the signs of the ray's direction so that
; the nearer of two children comes first; there is no stack.  Finished rays are
; removed by compression when they are a quarter of all.  A ray at a leaf makes
; pairs with the leaf's triangles and continues.  Pairs are tested before they
; outnumber the traversing rays.
;
; A ray is inside a box with centre C and half sides H, on each axis, for
;
;   (C - o) / d - H / |d|  <=  t  <=  (C - o) / d + H / |d|
;
; It hits the box if these intervals have a t >= 0 in common before the ray's
; limit.  The boxes exceed their contents by more than the rounding errors, and
; the entry is reduced a little for the errors of distant rays.  d = 0 counts as
; 1e-60.
;
; For a triangle, z is the axis on which |d| is greatest, and x, y are the next
; ones.  Its corners relative to o, sheared along d, are
; P = (x - z dx / dz, y - z dy / dz), so the ray is at the origin.  With
; a x b = ax by - ay bx:
;
;   U = P1 x P2    V = P2 x P0    W = P0 x P1       all >= 0 or all <= 0
;   t = (U z0 + V z1 + W z2) / dz / (U + V + W)     U + V + W not 0
;
; A sheared corner depends on the ray alone, products commute, and a difference
; and its opposite never have the same sign.  So two triangles with two common
; corners leave no gap.
;
; A ray to a light ends at the first triangle that it hits before the light.
;
; In:  ox oy oz dx dy dz lower near_limit, near long; the primitive's record and
;      table; shadows.
; Out: tin = tout = the smallest t beyond lower up to the limit, patch_s the
;      offset of its triangle in the table, of several the first, patch_t 0;
;      for a ray to a light any t before its limit; a miss is big, minus_big.
; Source: the edges: Woop, Benthin and Wald 2013; links by directions: threaded
; hierarchies, Arvo 1988; pairs: derived here.

        include_form lanes

; The m traversing rays: node, index among the near rays, origin, 1/d, 1/|d|,
; twice the number of its signs, limit.
        .share  hits
        .regs   r136, mesh_at, mesh_ray, mesh_ox, mesh_oy, mesh_oz
        .regs   r141, mesh_ix, mesh_iy, mesh_iz, mesh_ax, mesh_ay, mesh_az
        .regs   r147, mesh_signs, mesh_limit
        .regs   r149, mesh_low, mesh_high, mesh_g0, mesh_g1, mesh_g2, mesh_g3
        .regs   r155, mesh_bits, mesh_hit
        .regs   mesh_at, walk0, walk1, walk2, walk3, walk4, walk5, walk6, walk7
        .regs   mesh_ax, walk8, walk9, walk10, walk11, walk12
        .equ    WALK_VECTORS, 21
        .regs   r157, mesh_table, mesh_row, mesh_links, mesh_leaf_link
        .reg    mesh_pairs, r161
        .endshare

; Rays at a leaf: its next triangle, their indices, the number of its remaining
; triangles.
        .share  hits
        .regs   r162, leaf_triangle, leaf_ray, leaf_left, leaf_bits
        .reg    leaf_count, r166
        .endshare

; Pairs: rays and triangles, three corners by x, y, z of the ray's own axes, U,
; V, W.
        .share  scratch
        .regs   r233, side_ray, side_triangle, side_x0, side_y0, side_z0
        .regs   r238, side_x1, side_y1, side_z1, side_x2, side_y2, side_z2
        .regs   r244, side_u, side_v, side_w, side_g0
        .regs   r248, side_bits, side_more, side_tie
        .endshare
        .reg    side_g1, side_w                 ; while W is not in use
        .equ    SIDE_VECTORS, 18
        .equ    PARTS_BITS, 2
        .equ    PARTS, 1 << PARTS_BITS

; All these vectors share the memory of the lanes of other shapes.  bits0 and
; bits1 are no longer needed when the traversal begins.
        .data
mesh_zero:      .word 1e-60
walk_bases:
        vector_bases WALK_VECTORS - 2, lane_store, 2, near_bit_store
side_bases:
        vector_bases SIDE_VECTORS - 3, side_store, 3, lane_bits
        .equ    side_store, lane_store + 64 * QUEUE * (WALK_VECTORS - 2)
        .if     WALK_VECTORS - 2 + SIDE_VECTORS - 3 > LANE_VECTORS + SHADE_VECTORS - 4
        .error  "the lanes' vectors have no room for those of meshes"
        .endif
        .code

; Sets the lengths of the traversing rays' vectors to m.
        .macro  set_walk
        set_lengths m, m_high, walk_bases, lane_shade_descriptors, WALK_VECTORS, mesh_at
        .endm

        .macro  set_sides count
        set_lengths \count, m_high, side_bases, lane_descriptors, SIDE_VECTORS, side_ray
        .endm

; [kx], [ky], [kz] = x, y, z in the order of each ray's own axes: y is the
; greatest in the lanes of bits0, z in those of bits1.
        .macro  local_axis a, b, c, into
        VTOV    \a, [\into]
        VTOV    \b, [\into] ? [bits0]
        VTOV    \c, [\into] ? [bits1]
        .endm

        .macro  local_axes x, y, z, kx, ky, kz
        local_axis \y, \z, \x, \kx
        local_axis \z, \x, \y, \ky
        local_axis \x, \y, \z, \kz
        .endm

; Neighbouring rays visit the same nodes, whose words are in one memory bank,
; and a bank is busy for four accesses.  So the rays are taken from each of
; PARTS parts in turn:
; [mesh_ray] = i / PARTS + (i mod PARTS) * (size of a part), without the
; values that are m or more.  i runs to m, rounded up to a multiple of PARTS;
; the vectors of pairs have room for it.
        .macro  mix_rays
        EX      s2, PARTS - 1
        ADDX    m, s2, s3
        SHIFTI  s3, -PARTS_BITS, s3
        SHIFTI  s3, PARTS_BITS, s4
        set_sides s4
        INTVLV  r0, one_index, [side_x0]
        ANDV    [side_x0], s2, [side_x1]
        ES      s2, -PARTS_BITS
        SHIFTV  [side_x0], s2, [side_x0]
        MPYLV   [side_x1], s3, [side_x1]
        ADDXV   [side_x0], [side_x1], [side_x0]
        CMPLTV  [side_x0], m, [side_bits]
        CPSV    [side_x0], [mesh_ray] ? [side_bits]
        .endm

        .macro  begin_axis o, d, sign, own, inverse, size
        VXTOV   [mesh_ray], [\o], [\own]
        VXTOV   [mesh_ray], [\d], [mesh_g0]
        ES      s2, 2 * \sign
        CMPLTV  [mesh_g0], r0, [mesh_bits]
        ADDXV   [mesh_signs], s2, [mesh_signs] ? [mesh_bits]
        CMPEQV  [mesh_g0], r0, [mesh_bits]
        VTOV    s1, [mesh_g0] ? [mesh_bits]
        DIVSV   one, [mesh_g0], [\inverse]
        ABSV    [\inverse], [\size]
        .endm

; [low], [high] = the interval in the box at MESH_BOX + number along one axis.
        .macro  box_axis number, own, inverse, size, low, high
        address_of mesh_table, MESH_BOX + \number, s0
        VXTOV   [mesh_at], [s0], [mesh_g0]
        IX      s0, 64 * 3
        VXTOV   [mesh_at], [s0], [mesh_g1]
        SUBNV   [mesh_g0], [\own], [mesh_g0]
        MPYSV   [mesh_g0], [\inverse], [mesh_g0]
        MPYSV   [mesh_g1], [\size], [mesh_g1]
        SUBNV   [mesh_g0], [mesh_g1], [\low]
        ADDNV   [mesh_g0], [mesh_g1], [\high]
        .endm

; Intersects the interval with that of one more axis.
        .macro  box_next number, own, inverse, size
        box_axis \number, \own, \inverse, \size, mesh_g2, mesh_g3
        CMPLTV  [mesh_low], [mesh_g2], [mesh_bits]
        VTOV    [mesh_g2], [mesh_low] ? [mesh_bits]
        CMPLTV  [mesh_g3], [mesh_high], [mesh_bits]
        VTOV    [mesh_g3], [mesh_high] ? [mesh_bits]
        .endm

; Appends a vector of the rays at leaves to the pairs.  s0 = the offset of their
; end, in bits.
        .macro  add_pair vector, store
        EX      s1, \store
        ADDX    s1, s0, s1
        ADDLEN  s1, leaf_count, s1
        VTOV    [\vector], [s1]
        .endm

        .macro  walk_keep vector
        CPSV    [\vector], [\vector] ? [mesh_bits]
        .endm

        .macro  side_keep vector
        CPSV    [\vector], [\vector] ? [side_bits]
        .endm

; Keeps only the pairs of side_bits: their hits, or also U, V and W.
        .macro  keep_hits
        side_keep side_ray
        side_keep side_triangle
        side_keep side_z0
        .endm

        .macro  keep_sides
        keep_hits
        side_keep side_u
        side_keep side_v
        side_keep side_w
        side_keep side_z1
        side_keep side_z2
        .endm

; [into] = [vector] of the rays of the pairs.
        .macro  of_ray vector, into
        VXTOV   [side_ray], [\vector], [\into]
        .endm

; Gathers one coordinate of the corners, relative to the ray's origin.
        .macro  side_axis axis, o, c0, c1, c2
        of_ray  \axis, side_g0
        ADDXV   [side_triangle], [side_g0], [side_g0]
        RTOR    mesh_table, s0
        VXTOV   [side_g0], [s0], [\c0]
        IX      s0, 64 * 3
        VXTOV   [side_g0], [s0], [\c1]
        IX      s0, 64 * 3
        VXTOV   [side_g0], [s0], [\c2]
        of_ray  \o, side_g1
        SUBNV   [\c0], [side_g1], [\c0]
        SUBNV   [\c1], [side_g1], [\c1]
        SUBNV   [\c2], [side_g1], [\c2]
        .endm

        .macro  shear_corner z, c
        MPYSV   [side_g1], [\z], [side_g0]
        SUBNV   [\c], [side_g0], [\c]
        .endm

        .macro  shear by, c0, c1, c2
        of_ray  \by, side_g1
        shear_corner side_z0, \c0
        shear_corner side_z1, \c1
        shear_corner side_z2, \c2
        .endm

        .macro  side_edge ax, ay, bx, by, into
        MPYSV   [\ax], [\by], [\into]
        MPYSV   [\ay], [\bx], [side_g0]
        SUBNV   [\into], [side_g0], [\into]
        .endm

        .macro  side_and bits, a, b
        keep_where CMPGEV, \a, \b, \bits, side_tie
        .endm

; [side_z0] = U z0 + V z1 + W z2.
        .macro  weigh_corners
        MPYSV   [side_u], [side_z0], [side_z0]
        MPYSV   [side_v], [side_z1], [side_z1]
        MPYSV   [side_w], [side_z2], [side_z2]
        ADDNV   [side_z0], [side_z1], [side_z0]
        ADDNV   [side_z0], [side_z2], [side_z0]
        .endm

; Prepares the data of the near rays for a traversal: their own axes.
        .macro  begin_mesh
        address_of mesh_table, MESH_LINKS, mesh_links
        EX      mesh_leaf_link, MESH_LEAF_HIT
        ES      mesh_pairs, 0
        RTOR    near, m
        set_walk
        ABSV    [dx], [w2]
        ABSV    [dy], [w3]
        ABSV    [dz], [w4]
        CMPLTV  [w2], [w3], [bits0]
        VTOV    [w3], [w2] ? [bits0]
        CMPLTV  [w2], [w4], [bits1]
        local_axes [ox], [oy], [oz], w0, w1, w2
        local_axes [dx], [dy], [dz], w3, w4, w5
        ES      s2, 2
        local_axes r0, one_index, s2, w6, w7, w8
        DIVSV   one, [w5], [w5]
        MPYSV   [w3], [w5], [w3]
        MPYSV   [w4], [w5], [w4]
        .endm

; One step of the traversing rays: [mesh_bits] = those that hit the box of their
; node, [mesh_g1] = the next node of each.
        .macro  step_boxes
        load_word bound_less, s1
        box_axis 0, mesh_ox, mesh_ix, mesh_ax, mesh_low, mesh_high
        box_next 1, mesh_oy, mesh_iy, mesh_ay
        box_next 2, mesh_oz, mesh_iz, mesh_az
        MPYSV   [mesh_low], s1, [mesh_low]
        CMPGEV  [mesh_high], [mesh_low], [mesh_bits]
        keep_where CMPGEV, [mesh_high], r0, mesh_bits, mesh_hit
        keep_where CMPLTV, [mesh_low], [mesh_limit], mesh_bits, mesh_hit
        ADDXV   [mesh_at], [mesh_signs], [mesh_g0]
        ADDXV   [mesh_g0], one_index, [mesh_g0] ?! [mesh_bits]
        VXTOV   [mesh_g0], [mesh_links], [mesh_g1]
        .endm

        .macro  keep_boxes
        .rept   13
        walk_keep walk\+
        .endr
        .endm

        .macro  limit_boxes limits
        VXTOV   [mesh_ray], [\limits], [mesh_limit]
        .endm

; [mesh_ray] = the near rays in the order of the traversal.
        .macro  set_mesh_rays
        .if     QUEUE < PARTS || QUEUE > 65535 - PARTS
        VTOV    [iota], [mesh_ray]
        .else
        mix_rays
        .endif
        .endm

        no_code among_all

; All rays, or those that among_\some selects, start at the first node.
        .macro  start_walk limits, some=all
        ES      s2, MESH_SIZE
        VTOV    s2, [mesh_at]
        set_mesh_rays
        limit_boxes \limits
        among_\some
        VTOV    r0, [mesh_signs]
        load_word mesh_zero, s1
        begin_axis ox, dx, 1, mesh_ox, mesh_ix, mesh_ax
        begin_axis oy, dy, 2, mesh_oy, mesh_iy, mesh_ay
        begin_axis oz, dz, 4, mesh_oz, mesh_iz, mesh_az
        .endm

        .if     MESH_BOXES == 0
        .include "shapes/mesh_screen_bounds_vector.s"
        .endif

; Traverses to the end.  The routine `intersect` tests the pairs; limits = 1: it
; may change limits.  first = the offset of a leaf's triangles from the links.
        .macro  walk_mesh intersect, limits, bounds=boxes, first=MESH_FIRST - MESH_LINKS
mesh_step\@:
        step_\bounds
        CMPGEV  [mesh_g1], mesh_leaf_link, [mesh_hit]
        CNTOB   [mesh_hit], leaf_count
        IBXNE   leaf_count, r0, r0, mesh_leaves\@
mesh_on\@:
        VTOV    [mesh_g1], [mesh_at]
        CMPNEV  [mesh_at], r0, [mesh_bits]
        if_none mesh_bits, s2, mesh_walked\@
        if_sparse  s2, m, mesh_narrow\@
        BIM     mesh_step\@
mesh_narrow\@:
        keep_\bounds
        RTOR    s2, m
        set_walk
        BIM     mesh_step\@

; leaf_count rays are at leaves: each makes a pair with each triangle.
mesh_leaves\@:
        SUBXV   [mesh_g1], mesh_leaf_link, [mesh_g1] ? [mesh_hit]
        RTOR    w10, leaf_triangle
        RTOR    w11, leaf_ray
        RTOR    mesh_g0, leaf_left
        CPSV    [mesh_at], [leaf_triangle] ? [mesh_hit]
        CPSV    [mesh_ray], [leaf_ray] ? [mesh_hit]
        address_of mesh_links, \first + 1, s0
        VXTOV   [leaf_triangle], [s0], [leaf_left]
        IX      s0, -64
        VXTOV   [leaf_triangle], [s0], [leaf_triangle]
leaf_next\@:
        ADDX    mesh_pairs, leaf_count, s0
        IBXLE   s0, r0, m, leaf_pairs\@
        call_routine \intersect, lane_link
        .if     \limits
        limit_\bounds w9
        .endif
leaf_pairs\@:
        SHIFTI  mesh_pairs, 6, s0
        add_pair leaf_ray, side_store
        add_pair leaf_triangle, side_store + 64 * QUEUE
        ADDX    mesh_pairs, leaf_count, mesh_pairs
        SUBXV   [leaf_left], one_index, [leaf_left]
        describe leaf_bits, lane_bits + 64 * QUEUE_BIT_WORDS * 3, leaf_count
        CMPNEV  [leaf_left], r0, [leaf_bits]
        if_none leaf_bits, leaf_count, mesh_on\@
        CPSV    [leaf_triangle], [leaf_triangle] ? [leaf_bits]
        CPSV    [leaf_ray], [leaf_ray] ? [leaf_bits]
        CPSV    [leaf_left], [leaf_left] ? [leaf_bits]
        ADDXV   [leaf_triangle], mesh_row, [leaf_triangle]
        BIM     leaf_next\@

mesh_walked\@:
        IBXEQ   mesh_pairs, r0, r0, mesh_done\@
        call_routine \intersect, lane_link
mesh_done\@:
        .endm

; Gathers the corners of the pairs' triangles: x, y, z, sheared.
        .macro  take_corners
        side_axis w6, w0, side_x0, side_x1, side_x2
        side_axis w7, w1, side_y0, side_y1, side_y2
        side_axis w8, w2, side_z0, side_z1, side_z2
        shear   w3, side_x0, side_x1, side_x2
        shear   w4, side_y0, side_y1, side_y2
        .endm

        .kernel mesh
mesh:
        load_record P_TABLE, 2, mesh_table      ; also mesh_row
        FLR     mesh_row, mesh_row
        begin_mesh
        VTOV    [near_limit], [w9]
        VTOV    big, [tin]
        VTOV    r0, [patch_s]                   ; before all triangles
        IBXNE   shadows, r0, r0, mesh_begin     ; hits at the light do not count
        VTOV    mesh_leaf_link, [patch_s]       ; after all: hits there count
mesh_begin:
        VTOV    r0, [patch_t]
        .if     MESH_BOXES == 0
        find_viewpoint mesh_no_viewpoint
        start_screen_bounds mesh_by_screen_bounds
        walk_mesh intersect_sides, 1, screen_bounds, SCREEN_FIRST - SCREEN_LINKS
mesh_by_screen_bounds:
        find_far mesh_walk_done
        BIM     mesh_boxes
mesh_no_viewpoint:
        ES      mesh_viewpoint, 0
mesh_boxes:
        start_walk near_limit, far
        .else
        start_walk near_limit
        .endif
        walk_mesh intersect_sides, 1
mesh_walk_done:
        CMPLTV  [tin], big, [bits0]
        MASKV   [tin], minus_big, [tout] ? [bits0]
        BIM     0, link_kernel

; Tests the mesh_pairs pairs.  Changes w9, tin, patch_s of the rays that are
; hit.
intersect_sides:
        set_sides mesh_pairs
        ES      mesh_pairs, 0
        take_corners
        side_edge side_x1, side_y1, side_x2, side_y2, side_u
        side_edge side_x2, side_y2, side_x0, side_y0, side_v
        side_edge side_x0, side_y0, side_x1, side_y1, side_w
        CMPGEV  [side_u], r0, [side_bits]
        side_and side_bits, [side_v], r0
        side_and side_bits, [side_w], r0
        CMPGEV  r0, [side_u], [side_more]
        side_and side_more, r0, [side_v]
        side_and side_more, r0, [side_w]
        ORB     [side_bits], [side_more], [side_bits]
        if_none side_bits, s2, sides_hit
        keep_sides
        set_sides s2
        weigh_corners
        ADDNV   [side_u], [side_v], [side_u]
        ADDNV   [side_u], [side_w], [side_u]
        of_ray  w5, side_g1
        MPYSV   [side_z0], [side_g1], [side_z0]
        CMPNEV  [side_u], r0, [side_bits]
        VTOV    one, [side_u] ?! [side_bits]
        DIVSV   [side_z0], [side_u], [side_z0]  ; t
        of_ray  lower, side_g1
        keep_where CMPLTV, [side_g1], [side_z0], side_bits, side_more
        BIM     sides_better

; Keeps the nearest hit of each ray.  If a ray has several, the last store wins,
; and that pair is excluded from the next pass.
sides_turn:
        ORNB    [side_bits], [side_bits], [side_bits]
sides_better:
        of_ray  w9, side_g0
        CMPEQV  [side_z0], [side_g0], [side_more]
        of_ray  patch_s, side_g1
        keep_where CMPLTV, [side_triangle], [side_g1], side_more, side_tie
        CMPLTV  [side_z0], [side_g0], [side_tie]
        ORB     [side_more], [side_tie], [side_more]
        ANDB    [side_bits], [side_more], [side_bits]
        if_none side_bits, s2, sides_hit
        keep_hits
        set_sides s2
        VTOVX   [side_ray], [side_z0], [tin]
        VTOVX   [side_ray], [side_triangle], [patch_s]
        IBXNE   shadows, r0, r0, sides_stop
        VTOVX   [side_ray], [side_z0], [w9]
        BIM     sides_turn
sides_stop:
        VTOVX   [side_ray], minus_big, [w9]
sides_hit:
        BIM     0, lane_link
        .endkernel

        .if     MESH_CROSSINGS
        .include "shapes/mesh_crossings_vector.s"
        .endif
