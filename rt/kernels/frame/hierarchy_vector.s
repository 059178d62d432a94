; hierarchy_vector.s - walks through the hierarchy of regions, for sets of rays.
;
; The current rays are tested against the sphere of a node, under their limits.
; If no ray is near, everything below the node is skipped. If few rays are near,
; they form a new set, with which both child nodes continue. Otherwise the set
; continues as it is. The child that is nearer along a ray from the middle of
; the set is visited first, so that its hits limit the other, which waits on a
; stack.
;
; A set has descriptors of its rays, of their positions in the queue and of
; their limits. The first set is the queue itself. The others are stored
; consecutively in an arena, each after its parent. The next node to visit
; belongs to an earlier set, and the memory after that set is free. Each set has
; less than SPARSE / SPARSE_OF = 3/4 of the rays of its parent, so all sets
; together have fewer than n (3/4 + 9/16 + ..) = 3 n rays. A ray has 8 words.
;
; The limits of a set are those of its rays when it was formed. They are
; gathered again after a region has received hits (walk_last).
;
; The walk only marks regions with clear parts for shadow rays, because the
; share of light that they transmit is a product in the order of the scene.
;
; walk_pop: continues with the next waiting node.  If there is none, it
;           continues, for shadow rays, with the next marked region.
; load_set: Out: ox .. dz, s8 = number of rays, s9 = descriptor of their limits.
; Source: the order: Kay and Kajiya 1986; sets of rays: derived here.

        .record SET
        .field  SET_RAY, 6              ; descriptors: origins, directions
        .field  SET_INDEX               ; positions in the queue
        .field  SET_LIMIT
        .field  SET_COUNT               ; number of rays, an integer
        .field  SET_LAST                ; walk_last when the limits were taken
        .field  SET_END                 ; address after the set
        .endrecord
        .equ    SET_VECTORS, 8

; With fewer regions the hierarchy is not used.
        .equ    HIERARCHY_FROM, 12
        .equ    NODE_OF_REGIONS, H_SPHERES + 1

; A node, while its bound is tested.
        .share  shape
        .regs   r61, hierarchy_regions, hierarchy_count
        .regs   r63, hierarchy_dirx, hierarchy_diry, hierarchy_dirz
        .reg    hierarchy_spheres, r66
        .endshare

        .data
walk_top:       .word 0                 ; address after the last waiting node
walk_set:       .word 0                 ; address of the current set
walk_last:      .word 0                 ; address of the last region with hits,
                                        ; or number of the last hits of pairs
walk_clear:     .word 0                 ; address of the next scene_clear word
walk_clear_left: .word 0                ; words from there on
walk_stack:     .space 2 * HIERARCHY_DEPTH ; waiting nodes, each with its set
queue_set:      .space SET_SIZE
        .align  64 * 512                ; memory that is not always in use has
                                        ; pages of its own
set_arena:      .space 3 * SET_VECTORS * QUEUE + HIERARCHY_DEPTH * SET_SIZE
        .align  64 * 512
        .code

; Records that region has changed limits.
        .macro  region_took_hits
        store_word region, walk_last, s0
        .endm

        .kernel bound
; The queue is the first set. Regions outside the hierarchy are visited first,
; and the first node waits.
begin_walk:
        store_words aox, 6, queue_set, s2
        describe s3, count_store, n
        RTOR    nearest, s4
        RTOR    n, s5
        ES      s6, 0
        EX      s7, set_arena
        IX      s2, 64 * SET_INDEX
        store_to s3, SET_SIZE - SET_INDEX, s2
        EX      s3, walk_stack
        EX      s4, queue_set
        ES      s5, 0
        load_word scene_clear, s6
        ES      s7, 0
        load_word scene_regions, region
        load_word scene_region_count, regions_left
        IBXEQ   shadows, r0, r0, begin_stack
        load_word scene_clear_count, s7
begin_stack:
        load_word scene_hierarchy, s0
        IBXEQ   s0, r0, r0, begin_state
        load_word scene_region_total, s1
        SUBX    s1, regions_left, s2            ; regions in the hierarchy
        ES      s8, HIERARCHY_FROM
        IBXLT   s2, r0, s8, begin_flat
        STO     [s3], s0
        IX      s3, 64
        STO     [s3], s4
        IX      s3, 64
begin_state:
        store_words s3, 5, walk_top, s2
        BIM     0, link_inner

; With few regions their own bounds are tested instead.
begin_flat:
        RTOR    s1, regions_left
        BIM     begin_state

load_set:
        load_word walk_set, s7
        EX      s0, queue_set
        IBXNE   s7, r0, s0, set_of_some
        set_rays aox, aoy, aoz, adx, ady, adz, aox
        RTOR    n, s8
        RTOR    nearest, s9
        BIM     0, link_inner
set_of_some:
        load_word walk_last, s8
        load_from s7, 6, ox
        IX      s7, 64 * SET_INDEX
        load_from s7, 4, s3
        IBXEQ   s8, r0, s6, set_limits
        VXTOV   [s3], [nearest], [s4]
        IX      s7, 64 * (SET_LAST - SET_INDEX)
        STO     [s7], s8
set_limits:
        RTOR    s5, s8
        RTOR    s4, s9
        BIM     0, link_inner

walk_pop:
        load_word walk_top, s1
        EX      s2, walk_stack
        IBXEQ   s1, r0, s2, walk_end
        IX      s1, -64 * 2
        store_word s1, walk_top, s2
        load_from s1, 2, region                 ; region, regions_left
        store_word regions_left, walk_set, s2
walk_node:
        load_from region, NODE_OF_REGIONS, bound_x
        IBXEQ   hierarchy_count, r0, one_index, walk_leaf
        call_routine load_set, link_inner
        call_routine test_queue_bound, link_inner
        IBXEQ   s0, r0, r0, walk_pop
        RTOR    s0, s6
        if_sparse  s6, s8, walk_narrow
walk_below:
        IBXNE   hierarchy_count, r0, r0, walk_leaf
        .ifdef  PAIRS
        IBXEQ   hierarchy_spheres, r0, r0, walk_nodes_below
        ES      s1, PAIR_SET
        IBXLE   s8, r0, s1, add_pairs
walk_nodes_below:
        .endif
        SHIFTI  s8, -1, s8                      ; a ray from the middle
        LOD     [dx, s8], s1
        LOD     [dy, s8], s2
        LOD     [dz, s8], s3
        IX      region, 64 * H_SIZE
        RTOR    hierarchy_regions, s4
        MPYS    s1, hierarchy_dirx, s1
        MPYS    s2, hierarchy_diry, s2
        MPYS    s3, hierarchy_dirz, s3
        ADDN    s1, s2, s1
        ADDN    s1, s3, s1
        load_word walk_top, s0
        load_word walk_set, s5
        CFPGE   s1, r0, walk_nearer
        RTOR    s4, s1
        RTOR    region, s4
        RTOR    s1, region
walk_nearer:
        STO     [s0], s4
        IX      s0, 64
        STO     [s0], s5
        IX      s0, 64
        store_word s0, walk_top, s5
        BIM     walk_node
walk_leaf:
        RTOR    hierarchy_count, regions_left
        RTOR    hierarchy_regions, region
        BIM     walk_next

; Makes a set of the s6 rays of near_bits, out of s8 rays.
        .macro  set_take vector
        CPSV    [\vector], [s5] ? [near_bits]
        RTOR    s5, \vector
        ADDX    s5, s2, s5
        .endm

        .macro  set_gather vector, into
        VXTOV   [s3], [\vector], [s5]
        RTOR    s5, \into
        ADDX    s5, s2, s5
        .endm

walk_narrow:
        load_word walk_set, s7
        IX      s7, 64 * SET_INDEX
        LOD     [s7], s3
        IX      s7, 64 * (SET_END - SET_INDEX)
        LOD     [s7], s1
        store_word s1, walk_set, s0
        address_of s1, SET_SIZE, s5
        ELEN    s5, 0
        ADDLEN  s5, s6, s5
        SHIFTI  s6, 6, s2
        set_take s3
        if_gather_pays s6, s8, s0, walk_gather
        RTOR    s9, s4
        set_take s4
        set_take dx
        set_take dy
        set_take dz
        IBXNE   from_one_point, r0, r0, walk_origin
        set_take ox
        set_take oy
        set_take oz
        BIM     walk_narrowed
walk_gather:
        set_gather nearest, s4
        set_gather adx, dx
        set_gather ady, dy
        set_gather adz, dz
        IBXNE   from_one_point, r0, r0, walk_origin
        set_gather aox, ox
        set_gather aoy, oy
        set_gather aoz, oz
        BIM     walk_narrowed
walk_origin:
        change_length ao, o, s6, n, s0
walk_narrowed:
        RTOR    s5, s7
        RTOR    s6, s5
        RTOR    s6, s8
        load_word walk_last, s6
        store_to ox, 6, s1
        IX      s1, 64 * SET_INDEX
        store_to s3, SET_SIZE - SET_INDEX, s1
        BIM     walk_below

walk_end:
        .ifdef  PAIRS
        call_routine finish_pairs, link_inner
        .endif

; Intersects the queue with the next marked region with clear parts.
walk_next_clear:
        load_words walk_clear, 2, s2, s1        ; s2, s3
        IBXEQ   s3, r0, r0, walk_done
        EX      s4, 65535
        IBXLE   s3, r0, s4, walk_search
        RTOR    s4, s3
walk_search:
        ELEN    s2, 0
        ADDLEN  s2, s3, s4
        SELNEV  [s4], r0, s5
        load_word walk_clear_left, s6
        SUBX    s6, s5, s6
        advance_by s2, s5, s7
        IBXEQ   s5, r0, s3, walk_searched       ; none among these
        LOD     [s2], region
        STO     [s2], r0
        IX      s2, 64
        ADDX    s6, minus_one_index, s6
walk_searched:
        RTOR    s6, s4
        RTOR    s3, s6
        RTOR    s4, s3
        store_words s2, 2, walk_clear, s1
        IBXEQ   s5, r0, s6, walk_next_clear
        EX      s1, walk_set
        EX      s2, queue_set
        STO     [s1], s2
        ES      regions_left, 1
        load_from region, REGION_WORDS, bound_x
        ES      region_shadow, 1                ; prevents another mark
        BIM     walk_bound
        .endkernel
