; trees_1984.s - finds the visible crossings of a region's tree in kernels mode.
;
; The vector kernels intersected all current rays with each leaf that any of
; them comes near. Before VISIBLE is called for a ray, its leaves are examined
; once: P_NEXT_HIT chains those that it hits, and required leaves narrow its
; span (span_scalar.s), as in nodes_scalar.s.
;
; The including file processes the crossings:
;
;   walk_tree:
;           walk_rays       ; w_in, w_out = distance, primitive of a crossing;
;           ..              ; loop_ray_index = position of the ray in the queue
;           rays_end        ; has tree_skip: the next ray, then the next region
;
; The argument of walk_rays is a macro that loads its own registers of the loop,
; once for a region.
;
; In: the crossings of the current rays with a region's primitives. begin_span
; and node_hit do nothing, because each ray is examined separately.

; Operands from the vector program.
        .share  loop
        .regs   r156, to_nearest, to_nearest_primitive, to_hit_s, to_hit_t, from_ray_index
        .regs   r161, from_limit, from_patch_s, from_patch_t, from_least
        .regs   r165, its_primitive, to_lights
        .equ    SIMPLE_OPERANDS, 11
        .regs   r167, its_region, from_ox, from_oy, from_oz, from_dx
        .regs   r172, from_dy, from_dz
        .equ    TREE_OPERANDS, 18

        .regs   r174, segment_in, segment_out, ray_limit
        .regs   r177, from_in, from_out, w_crossings, its_shadow, stride
        .regs   r182, from_red, from_green, from_blue
        .regs   r185, next_in, next_out, next_limit
        .reg    its_patch, r155

; The current leaf: the words of its record in the list, its address there, and
; the end of the list.
        .regs   r188, leaf_primitive, leaf_segments, leaf_events
        .regs   r191, leaf_first_state, leaf_first_event, leaf_value, leaf_needed
        .regs   r195, its_leaf, first_leaf, leaves_last, chain_at, apart, point_at
        .endshare

        .macro  pass_rays
        pass_operands nearest, 4
        pass_operands ray_index, 2, 4
        pass_operands patch_s, 2, 6
        pass_operands wlower, 1, 8
        pass_operands queue_primitive, 1, 9
        pass_operands shadows, 1, 10
        .endm

; Sets loop_ray_index to the position of the current ray in the queue.
        .macro  find_ray_index
        RTOR    loop_index, loop_ray_index
        IBXEQ   near, r0, n, found_ray_index\@
        LOD     [from_ray_index, loop_index], loop_ray_index
found_ray_index\@:
        .endm

        .macro  find_patch primitive
        load_of \primitive, P_ON_PATCH, its_patch
        .endm

; Loads the current ray, for crossings that serve normals and light.
        .macro  load_ray
        load_three from_ox, from_oy, from_oz, loop_ray_index, w_ox, w_oy, w_oz
        load_three from_dx, from_dy, from_dz, loop_ray_index, w_dx, w_dy, w_dz
        .endm

        .macro  walk_rays prepare=
        pass_rays
        pass_operands region, 1, 11
        pass_operands aox, 6, 12
        to_scalar
        load_words operands, TREE_OPERANDS, to_nearest
        \prepare
        RTOR    near, loop_count
        ES      loop_index, 0
        LOD     [from_least], w_lower
        RTOR    its_region, w_region
        IX      its_region, 64 * R_SHADOW
        LOD     [its_region], its_shadow
        EX      stride, STRIDE
        EX      apart, CROSSING_SIZE
        load_two_delta
        load_words scene_leaves, 2, first_leaf     ; first_leaf, leaves_last
        IBXEQ   first_leaf, r0, leaves_last, tree_end
        load_word branches_end, loop_work
        store_word loop_work, span + 64 * 2
tree_next:
        LOD     [from_limit, loop_index], w_end
        SHIFTI  loop_index, 6, w_crossings
        .if     INTERIORS
        LOD     [from_least, loop_index], w_least
        .else
        RTOR    w_lower, w_least
        .endif
        RTOR    first_leaf, its_leaf
        EX      chain_at, span + 64 * 3
        ES      w_hit, 0
tree_leaf:
        load_from its_leaf, LEAF_SIZE, leaf_primitive
        ADDX    leaf_first_state, w_crossings, leaf_first_state
        LOD     [leaf_first_state], w_in
        CFPGE   w_in, m_big, tree_missed
        STO     [chain_at], leaf_primitive
        address_of leaf_primitive, P_NEXT_HIT, chain_at
        ES      w_hit, 1
        IBXEQ   leaf_needed, r0, r0, tree_leaf_next
        IBXEQ   leaf_segments, r0, r0, tree_leaf_next
        narrow_span leaf_first_state, leaf_segments, apart, tree_skip
tree_leaf_next:
        IX      its_leaf, 64 * LEAF_SIZE
        IBXNE   its_leaf, r0, leaves_last, tree_leaf
        IBXEQ   w_hit, r0, r0, tree_skip
        STO     [chain_at], r0
        next_visible w_least, tree_skip
        find_ray_index
        .endm

; Sets segment_in, segment_out to the parameters of a patch, or to the triangle
; of a mesh and whether the ray leaves there. Branches to `none` for other
; shapes. Overwrites w_out.
        .macro  find_point none
        find_patch w_out
        IBXEQ   its_patch, r0, r0, \none
        .if     MESH_CROSSINGS
        SHIFTI  its_patch, -1, loop_work
        IBXEQ   loop_work, r0, m_index_one, tree_triangle
        .endif
        IX      w_out, 64 * P_FIRST_EVENT
        LOD     [w_out], loop_work
        ADDX    w_crossings, loop_work, point_at
        load_words k_delta, 1, ray_limit
        SUBN    w_in, ray_limit, next_in
        ADDN    w_in, ray_limit, next_out
tree_crossing:
        LOD     [point_at], segment_in
        ADDX    point_at, stride, point_at
        CFPLT   segment_in, next_in, tree_crossing
        CFPLT   next_out, segment_in, tree_crossing
        IX      point_at, STRIDE * (PATCH_CROSSINGS - 1)
        LOD     [point_at], segment_in
        IX      point_at, STRIDE * PATCH_CROSSINGS
        LOD     [point_at], segment_out
tree_point:
        .endm

        .macro  rays_end
tree_skip:
        loop_next tree_next
tree_end:
        to_vector
        region_took_hits
        BIM     walk_skip


        .if     MESH_CROSSINGS
; Finds the triangle of a mesh, and whether the ray leaves there, as in
; regions_scalar.s.
tree_triangle:
        RTOR    its_patch, next_limit
        address_of w_out, P_SHAPE + 1, loop_at
        LOD     [loop_at], its_patch
        FLR     its_patch, its_patch
        EX      loop_work, CROSSING_SIZE
        MPYX    its_patch, loop_work, its_patch
        IX      loop_at, 64 * (P_SEGMENTS - P_SHAPE - 1)
        LOD     [loop_at], ray_limit
        ES      loop_work, 2
        IBXEQ   next_limit, r0, loop_work, tree_sided
        RTOR    r0, ray_limit
tree_sided:
        IX      w_out, 64 * P_FIRST_EVENT
        LOD     [w_out], loop_work
        ADDX    w_crossings, loop_work, point_at
        load_words k_delta, 1, segment_out
        SUBN    w_in, segment_out, next_in
        ADDN    w_in, segment_out, next_out
        ES      segment_out, 0
        BIM     tree_triangle_here
tree_triangle_next:
        ADDX    point_at, stride, point_at
        IBXEQ   ray_limit, r0, r0, tree_triangle_here
        XOR     segment_out, m_index_one, segment_out
tree_triangle_here:
        LOD     [point_at], segment_in
        CFPLT   segment_in, next_in, tree_triangle_next
        CFPLT   next_out, segment_in, tree_triangle_next
        LOD     [point_at, its_patch], segment_in
        BIM     tree_point
        .endif

tree_missed:
        STO     [leaf_value], r0
        IBXEQ   leaf_needed, r0, r0, tree_leaf_next
        BIM     tree_skip
        .endm

        .kernel visible
begin_span:
        BIM     0, link_inner
node_hit:
        BIM     node_next
        .endkernel
