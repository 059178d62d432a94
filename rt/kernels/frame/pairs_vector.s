; pairs_vector.s - intersects many small spheres, as pairs of a ray and a node.
;
; Below a node with many spheres, each sphere is hit by one or two rays, and the
; vectors of a node's rays are short. So at a node that has only spheres below
; it, the rays of a set of at most PAIR_SET are added to a pool of pairs with
; its child nodes. Each pair has its own ray and its own node. One stream tests
; pairs of different nodes and gathers the fields of the nodes. A pair whose ray
; is near makes two pairs with the child nodes. At a leaf it is added to a list
; of pairs with spheres, which are also intersected together, with a centre and
; a radius for each pair.
;
; The pool is a stack. Up to PAIRS pairs are taken from its top at a time. Rays
; are added only if the pool then has at most PAIRS pairs. Its size has a bound:
; give all pairs the label D at that time, the depth of the hierarchy, and give
; the pairs made from a batch the greatest label in the batch, minus one. Labels
; decrease towards the top. All pairs of one label come from one batch, because
; a batch that reaches the next higher label contains all pairs of this label. A
; batch makes 2 PAIRS pairs, and PAIRS of them are taken before a lower label
; appears. So the pool never has more than PAIRS (D + 2) pairs.
;
; A ray may be in several pairs of a batch. Its nearest hit is found by
; scattering all hits that improve on its current hit, then those that still
; improve on it, until none does. Each step eliminates the hit that was stored
; last.
;
; The bits are those of bound_vector.s and sphere_vector.s, operation by
; operation, and the nearest hits are the same.
;
; add_pairs:   In: region, a node with only spheres, s8 rays of walk_set.
; drain_pairs: processes the pool until at most pairs_capacity are left.
; Source: derived here.

        .share  hits
        .regs   r136, pair_ray, pair_node, pair_x, pair_y, pair_z
        .regs   r141, pair_dx, pair_dy, pair_dz, pair_b, pair_work, pair_limit
        .regs   pair_x, pair0, pair1, pair2, pair3, pair4, pair5, pair6, pair7
        .reg    pair8, pair_limit
        .regs   r147, pair_bits, pair_more, pair_tie, pair_in, pair_out
        .regs   r152, pair_hit, pair_count, pair_left
        .endshare
        .equ    PAIR_STRIDE, 1021
        .equ    PAIR_LIST, (1 + MAX_SPHERES) * PAIRS

        .data
pool_count:     .word 0
sphere_count:   .word 0                 ; pairs with spheres
pairs_capacity: .word 0                 ; pairs that may be left in the pool
pair_stamp:     .word 0                 ; number of the last hits, for walk_last
pair_order:     .space PAIRS            ; permutation, made at its first use
pair_bit_store: .space 3 * PAIR_LIST / 64
        .align  64
pool_rays:      .space PAIRS * (HIERARCHY_DEPTH + 2)
pool_nodes:     .space PAIRS * (HIERARCHY_DEPTH + 2) ; addresses, in words
sphere_rays:    .space PAIR_LIST
sphere_regions: .space PAIR_LIST
pair_store:     .space 12 * PAIR_LIST
        .align  64 * 512
        .code

        .macro  pair_vector register, number, count
        describe \register, pair_store + 64 * PAIR_LIST * \number, \count
        .endm

; Makes the descriptor of `count` words, `offset` bits after the address.
        .macro  pool_part register, address, offset, count
        EX      \register, \address
        ADDX    \register, \offset, \register
        ADDLEN  \register, \count, \register
        .endm

        .macro  set_pairs count
        .rept   9
        pair_vector pair\+, \+, \count
        .endr
        describe pair_bits, pair_bit_store, \count
        describe pair_more, pair_bit_store + PAIR_LIST, \count
        describe pair_tie, pair_bit_store + 2 * PAIR_LIST, \count
        .endm

; [into] = the field of the records whose word addresses are in [at].
        .macro  pair_field at, field, into
        EX      s0, 64 * (\field)
        VXTOV   [\at], [s0], [\into]
        .endm

; [into] = word addresses from an address field of the records.
        .macro  pair_address at, field, into
        pair_field \at, \field, \into
        ES      s0, -6
        SHIFTV  [\into], s0, [\into]
        .endm

; [pair_x] = field - o, [pair_dx] = direction, for the axis x, y or z.
        .macro  pair_axis axis, field
        pair_field pair_node, \field, pair_\axis
        IBXNE   from_one_point, r0, r0, pair_one_point\@
        VXTOV   [pair_ray], [ao\axis], [pair_work]
        SUBNV   [pair_\axis], [pair_work], [pair_\axis]
        BIM     pair_from\@
pair_one_point\@:
        LOD     [ao\axis], s1
        SUBNV   [pair_\axis], s1, [pair_\axis]
pair_from\@:
        VXTOV   [pair_ray], [ad\axis], [pair_d\axis]
        .endm

        .kernel bound
; Adds pairs of all rays of the set with each child of region.
add_pairs:
        load_word pool_count, s0
        ADDX    s8, s8, s1
        ADDX    s0, s1, s1
        EX      s2, PAIRS
        IBXGT   s1, r0, s2, add_after
        store_word s1, pool_count, s2
        load_word walk_set, s3
        IX      s3, 64 * SET_INDEX
        LOD     [s3], s3
        SHIFTI  s0, 6, s0
        SHIFTI  s8, 6, s5
        pool_part s4, pool_rays, s0, s8
        VTOV    [s3], [s4]
        ADDX    s4, s5, s4
        VTOV    [s3], [s4]
        pool_part s4, pool_nodes, s0, s8
        address_of region, H_SIZE, s1
        SHIFTI  s1, -6, s1
        VTOV    s1, [s4]
        ADDX    s4, s5, s4
        SHIFTI  hierarchy_regions, -6, s1
        VTOV    s1, [s4]
        BIM     walk_pop
add_after:
        SUBX    s2, s8, s2
        SUBX    s2, s8, s2
        store_word s2, pairs_capacity, s3
        call_routine mix_pairs, link_kernel
        BIM     walk_node

; Processes all remaining pairs.
finish_pairs:
        store_word r0, pairs_capacity, s3
        call_routine mix_pairs, link_kernel
        call_routine intersect_spheres, link_kernel
        BIM     0, link_inner

; Permutes the pool. Neighbouring pairs belong to one node, whose fields would
; be gathered from one bank repeatedly. The permutation moves neighbours
; PAIR_STRIDE apart, which is odd.
mix_pairs:
        load_word pool_count, s8
        ES      s1, 64
        IBXLT   s8, r0, s1, drain_pairs
        EX      s2, PAIRS
        describe s3, pair_order, s2
        LOD     [s3, one_index], s1
        IBXNE   s1, r0, r0, mix_ordered
        EX      s1, PAIR_STRIDE
        INTVLV  r0, s1, [s3]
        EX      s1, PAIRS - 1
        ANDV    [s3], s1, [s3]
mix_ordered:
        describe pair_bits, pair_bit_store, s2
        CMPLTV  [s3], s8, [pair_bits]
        EX      pair_x, pair_store
        CPSV    [s3], [pair_x] ? [pair_bits]
        pair_vector pair_y, 1, s8
        describe s3, pool_rays, s8
        VXTOV   [pair_x], [s3], [pair_y]
        VTOV    [pair_y], [s3]
        describe s3, pool_nodes, s8
        VXTOV   [pair_x], [s3], [pair_y]
        VTOV    [pair_y], [s3]
drain_pairs:
        load_word sphere_count, s0
        EX      s1, PAIRS
        IBXLT   s0, r0, s1, pairs_take
        RTOR    link_kernel, link
        call_routine intersect_spheres, link_kernel
        RTOR    link, link_kernel
pairs_take:
        load_word pool_count, s8
        load_word pairs_capacity, s1
        IBXLE   s8, r0, s1, pairs_drained
        EX      s1, PAIRS
        ES      s2, 0
        IBXLE   s8, r0, s1, pairs_some
        SUBX    s8, s1, s2
        RTOR    s1, s8
pairs_some:
        store_word s2, pool_count, s0
        SHIFTI  s2, 6, s2
        pool_part pair_ray, pool_rays, s2, s8
        pool_part pair_node, pool_nodes, s2, s8
        set_pairs s8
        load_word bound_less, s7
        pair_axis x, H_BOUND
        pair_axis y, H_BOUND + 1
        pair_axis z, H_BOUND + 2
        dot_vectors pair_x, pair_y, pair_z, pair_dx, pair_dy, pair_dz, pair_b, pair_work
        MPYSV   [pair_x], [pair_x], [pair_x]
        MPYSV   [pair_y], [pair_y], [pair_y]
        ADDNV   [pair_y], [pair_x], [pair_x]
        MPYSV   [pair_z], [pair_z], [pair_z]
        ADDNV   [pair_z], [pair_x], [pair_x]
        pair_field pair_node, H_BOUND + 3, pair_y
        MPYSV   [pair_y], [pair_y], [pair_z]
        LINKV
        MPYSV   [pair_x], s7, [pair_x]
        SUBNV   [pair_x], [pair_z], [pair_x]
        MPYSV   [pair_b], [pair_b], [pair_z]
        CMPGEV  [pair_z], [pair_x], [pair_bits]
        if_none pair_bits, s0, pairs_take
        VXTOV   [pair_ray], [nearest], [pair_limit]
        ADDNV   [pair_b], [pair_y], [pair_x]
        keep_where CMPLTV, r0, [pair_x], pair_bits, pair_more
        SUBNV   [pair_b], [pair_y], [pair_x]
        keep_where CMPLTV, [pair_x], [pair_limit], pair_bits, pair_more
        if_none pair_bits, s8, pairs_take
        CPSV    [pair_ray], [pair_ray] ? [pair_bits]
        CPSV    [pair_node], [pair_node] ? [pair_bits]

; Adds the regions of leaves to the list: first the first region of each leaf,
; then the others.
        set_pairs s8
        pair_field pair_node, H_REGION_COUNT, pair_x
        CMPNEV  [pair_x], r0, [pair_bits]
        if_none pair_bits, s5, pairs_below
        RTOR    pair_ray, s6
        RTOR    pair_node, s7
        IBXEQ   s5, r0, s8, pairs_leaves
        pair_vector s6, 9, s5
        pair_vector s7, 10, s5
        CPSV    [pair_ray], [s6] ? [pair_bits]
        CPSV    [pair_node], [s7] ? [pair_bits]
        CPSV    [pair_x], [pair_x] ? [pair_bits]
        NANDB   [pair_bits], [pair_bits], [pair_bits]
        CPSV    [pair_ray], [pair_ray] ? [pair_bits]
        CPSV    [pair_node], [pair_node] ? [pair_bits]
pairs_leaves:
        SUBX    s8, s5, s8
        pair_address s7, H_REGIONS, s7
        ES      s9, 1
pairs_leaf:
        load_word sphere_count, s1
        SHIFTI  s1, 6, s2
        ADDX    s1, s5, s1
        store_word s1, sphere_count, s3
        pool_part s3, sphere_rays, s2, s5
        VTOV    [s6], [s3]
        pool_part s3, sphere_regions, s2, s5
        VTOV    [s7], [s3]
        describe pair_more, pair_bit_store + PAIR_LIST, s5
        CMPLTV  s9, [pair_x], [pair_more]
        if_none pair_more, s5, pairs_no_leaf
        CPSV    [s6], [s6] ? [pair_more]
        CPSV    [s7], [s7] ? [pair_more]
        CPSV    [pair_x], [pair_x] ? [pair_more]
        ES      s1, R_SIZE
        ADDXV   [s7], s1, [s7]
        IX      s9, 1
        BIM     pairs_leaf
pairs_no_leaf:
        IBXEQ   s8, r0, r0, drain_pairs
        pair_vector pair_x, 0, s8

; Returns the child nodes of the other pairs to the pool, from the position of
; these pairs on.
pairs_below:
        SHIFTI  s8, 6, s5
        RTOR    pair_ray, s3
        ADDX    s3, s5, s3
        VTOV    [pair_ray], [s3]
        pair_address pair_node, H_REGIONS, pair_x
        ES      s1, H_SIZE
        ADDXV   [pair_node], s1, [pair_node]
        RTOR    pair_node, s3
        ADDX    s3, s5, s3
        VTOV    [pair_x], [s3]
        load_word pool_count, s1
        ADDX    s1, s8, s1
        ADDX    s1, s8, s1
        store_word s1, pool_count, s2
        BIM     drain_pairs
pairs_drained:
        BIM     0, link_kernel
        .endkernel

; Selects the crossing of a sphere, and tests whether it is beyond the least
; distance.
        .macro  spheres_ahead least
        CMPLTV  \least, [pair_in], [pair_bits]
        MASKV   [pair_in], [pair_out], [pair_hit] ? [pair_bits]
        CMPLTV  \least, [pair_hit], [pair_bits]
        .endm

; Intersects the pairs of the list.
        .kernel sphere
intersect_spheres:
        load_word sphere_count, pair_count
        IBXEQ   pair_count, r0, r0, spheres_hit
        store_word r0, sphere_count, s0
        set_pairs pair_count
        describe pair_ray, sphere_rays, pair_count
        describe pair_node, sphere_regions, pair_count
        pair_vector pair_in, 9, pair_count
        pair_vector pair_out, 10, pair_count
        pair_vector pair_hit, 11, pair_count
        pair_address pair_node, R_FIRST, pair_node
        pair_axis x, P_SHAPE
        pair_axis y, P_SHAPE + 1
        pair_axis z, P_SHAPE + 2
        pair_field pair_node, P_SHAPE + 3, pair_hit
        sphere_segment pair_x, pair_y, pair_z, pair_dx, pair_dy, pair_dz, [pair_hit], pair_b, pair_work, pair_in, pair_out, pair_bits
        .endkernel

        .kernel visible
        VXTOV   [pair_ray], [nearest], [pair_limit]
        RTOR    tmin, s1
        IBXEQ   shadows, r0, r0, spheres_least
        load_word k_shadow, s1
spheres_least:
        .if     INTERIORS
        load_word queue_passed, s2
        IBXEQ   s2, r0, r0, spheres_from_start
        IBXNE   shadows, r0, r0, spheres_from_start
        load_word k_delta, s3
        SUBN    r0, s3, s3
        VXTOV   [pair_ray], [s2], [pair_work]
        CMPNEV  [pair_work], r0, [pair_more]
        MASKV   s3, s1, [pair_work] ? [pair_more]
        spheres_ahead [pair_work]
        BIM     spheres_found
spheres_from_start:
        .endif
        spheres_ahead s1
        IBXNE   shadows, r0, r0, spheres_stop
spheres_found:
        keep_where CMPGEV, [pair_limit], [pair_hit], pair_bits, pair_more
        if_none pair_bits, pair_count, spheres_hit
        CPSV    [pair_ray], [pair_ray] ? [pair_bits]
        CPSV    [pair_hit], [pair_hit] ? [pair_bits]
        CPSV    [pair_node], [pair_node] ? [pair_bits]
        set_pairs pair_count

; Lists the materials of the hits. A material that is repeated in consecutive
; pairs is processed once.
        pair_field pair_node, P_MATERIAL, pair_x
spheres_compare:
        LOD     [pair_x], s2
        address_of s2, P_SHARED, s3
        STO     [s3], one_index
        IX      s3, 64 * (P_TESTED - P_SHARED)
        LOD     [s3], s4
        IBXNE   s4, r0, r0, spheres_listed
        EX      s5, first_material
        LOD     [s5], s4
        STO     [s3], s4
        STO     [s5], s2
spheres_listed:
        SELNEV  [pair_x], s2, s1
        LTOR    pair_x, s3
        IBXEQ   s1, r0, s3, spheres_nearest
        SUBX    r0, s1, s3
        ADDLEN  pair_x, s3, pair_x
        SHIFTI  s1, 6, s1
        ADDX    pair_x, s1, pair_x
        BIM     spheres_compare

; Finds the nearest hit of each ray.
spheres_nearest:
        pair_field pair_node, P_ID, pair_y
        ES      pair_left, 0
spheres_better:
        VXTOV   [pair_ray], [nearest], [pair_limit]
        CMPLTV  [pair_hit], [pair_limit], [pair_bits]
        CMPEQV  [pair_hit], [pair_limit], [pair_more]
        if_none pair_more, s0, spheres_no_tie
        VXTOV   [pair_ray], [nearest_primitive], [pair_limit]
        keep_where CMPLTV, [pair_y], [pair_limit], pair_more, pair_tie
        ORB     [pair_bits], [pair_more], [pair_bits]
spheres_no_tie:
        if_none pair_bits, s8, spheres_stamp
        ES      pair_left, 1
        IBXEQ   s8, r0, pair_count, spheres_scatter
        CPSV    [pair_ray], [pair_ray] ? [pair_bits]
        CPSV    [pair_hit], [pair_hit] ? [pair_bits]
        CPSV    [pair_y], [pair_y] ? [pair_bits]
        RTOR    s8, pair_count
        pair_vector pair_limit, 8, s8
        describe pair_bits, pair_bit_store, s8
        describe pair_more, pair_bit_store + PAIR_LIST, s8
        describe pair_tie, pair_bit_store + 2 * PAIR_LIST, s8
spheres_scatter:
        VTOVX   [pair_ray], [pair_hit], [nearest]
        .if     KEYS
        describe s0, depth_store, n
        VTOVX   [pair_ray], [pair_hit], [s0]
        .endif
        VTOVX   [pair_ray], [pair_y], [nearest_primitive]
        BIM     spheres_better

; Blocks shadow rays.
spheres_stop:
        keep_where CMPLTV, [pair_hit], [pair_limit], pair_bits, pair_more
        if_none pair_bits, pair_left, spheres_hit
        CPSV    [pair_ray], [pair_ray] ? [pair_bits]
        VTOVX   [pair_ray], minus_big, [nearest]
spheres_stamp:
        IBXEQ   pair_left, r0, r0, spheres_hit
        load_word pair_stamp, s0
        IX      s0, 1
        store_word s0, pair_stamp, s1
        store_word s0, walk_last, s1
spheres_hit:
        BIM     0, link_kernel
        .endkernel
