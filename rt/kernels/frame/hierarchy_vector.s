; hierarchy_vector.s - the regions that rays of a queue come near, found by a
; walk through a hierarchy of bounding spheres.
;
; At a node the rays at hand are tested against its sphere under their limits.
; None near: all that is below it is passed over.  Few: these make a set of their
; own, which both nodes below go on with; else they use the set as it is.  The
; node below that is nearer along a ray from the middle of the set goes first, so
; that what it has limits the other, which waits on a stack.
;
; A set has descriptors of its rays, their places in the queue and limits.  The
; first is the queue itself.  The others stand one behind the other in an arena,
; each behind the one that it was taken from: what is tried next after a node
; belongs to a set further down, and all above that is free again.  Each has
; less than FEW / FEW_OF of the rays of the one below, 3/4, so all that stand at
; a time have fewer than n (3/4 + 9/16 + ..) = 3 n; a ray has 8 words.
;
; The limits of a set are those of its rays when it was taken; they are gathered
; again when a region has been met since that took hits (walk_last).
;
; walk_pop: the next node that waits, or if there is none, of shadows, the next
;   of the regions with clear parts.  What they let pass is a product in the
;   order of the scene: so the walk only marks them.
; load_set: Out: ox .. dz, s8 = how many, s9 = the descriptor of their limits.
; Source: the order: Kay and Kajiya 1986; sets of rays: derived here.

        .record SET
        .field  SET_RAY, 6              ; descriptors: origins, directions,
        .field  SET_PLACE               ; places in the queue
        .field  SET_LIMIT
        .field  SET_COUNT               ; how many rays, an integer
        .field  SET_LAST                ; walk_last when the limits were taken
        .field  SET_END                 ; address of what is behind it
        .endrecord
        .equ    SET_VECTORS, 8

; Fewer regions are met without a walk.
        .equ    HIERARCHY_FROM, 12
        .equ    NODE_OF_REGIONS, H_SPHERES + 1

; Of a node, while its bound is tested.
        .share  shape
        .regs   r61, hierarchy_regions, hierarchy_count
        .regs   r63, hierarchy_wayx, hierarchy_wayy, hierarchy_wayz
        .reg    hierarchy_spheres, r66
        .endshare

        .data
walk_top:       .word 0                 ; address behind the last node that waits
walk_set:       .word 0                 ; .. of the set at hand
walk_last:      .word 0                 ; .. of the last region that took hits, or a
                                        ; number of such pairs
walk_clear:     .word 0                 ; .. of the next word of scene_clear
walk_clear_left: .word 0                ; words from there on
walk_stack:     .space 2 * HIERARCHY_DEPTH ; nodes that wait, each with its set
queue_set:      .space SET_SIZE
        .align  64 * 512                ; what takes turns with other memory is
                                ; on pages of its own
set_arena:      .space 3 * SET_VECTORS * QUEUE + HIERARCHY_DEPTH * SET_SIZE
        .align  64 * 512
        .code

; Region has changed limits.
        .macro  region_took_hits
        EX      s0, walk_last
        STO     [s0], region
        .endm

        .kernel bound
; The queue is the first set; the regions under no node are the first to be
; met, the first node of the hierarchy waits.
begin_walk:
        EX      s2, queue_set
        ELEN    s2, 6
        SWAP    [r0], aox, [s2]
        describe s3, count_store, n
        RTOR    nearest, s4
        RTOR    n, s5
        ES      s6, 0
        EX      s7, set_arena
        IX      s2, 64 * SET_PLACE
        ELEN    s2, SET_SIZE - SET_PLACE
        SWAP    [r0], s3, [s2]
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
        SUBX    s1, regions_left, s2            ; those under nodes
        ES      s8, HIERARCHY_FROM
        IBXLT   s2, r0, s8, begin_flat
        STO     [s3], s0
        IX      s3, 64
        STO     [s3], s4
        IX      s3, 64
begin_state:
        EX      s2, walk_top
        ELEN    s2, 5
        SWAP    [r0], s3, [s2]
        BIM     0, link_inner

; So few that their own bounds are tested instead.
begin_flat:
        RTOR    s1, regions_left
        BIM     begin_state

load_set:
        load_word walk_set, s7
        EX      s0, queue_set
        IBXNE   s7, r0, s0, set_of_some
        look_at_rays aox, aoy, aoz, adx, ady, adz, aox
        RTOR    n, s8
        RTOR    nearest, s9
        BIM     0, link_inner
set_of_some:
        load_word walk_last, s8
        ELEN    s7, 6
        SWAP    [s7], ox, [r0]
        IX      s7, 64 * SET_PLACE
        ELEN    s7, 4
        SWAP    [s7], s3, [r0]
        IBXEQ   s8, r0, s6, set_limits
        VXTOV   [s3], [nearest], [s4]
        IX      s7, 64 * (SET_LAST - SET_PLACE)
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
        EX      s2, walk_top
        STO     [s2], s1
        ELEN    s1, 2
        SWAP    [s1], region, [r0]              ; and regions_left
        EX      s2, walk_set
        STO     [s2], regions_left
walk_node:
        ELEN    region, NODE_OF_REGIONS
        SWAP    [region], bound_x, [r0]
        IBXEQ   hierarchy_count, r0, one_index, walk_leaf
        EX      target, load_set
        BSAVE   link_inner, [target]
        EX      target, test_queue_bound
        BSAVE   link_inner, [target]
        IBXEQ   s0, r0, r0, walk_pop
        RTOR    s0, s6
        if_few  s6, s8, walk_narrow
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
        MPYS    s1, hierarchy_wayx, s1
        MPYS    s2, hierarchy_wayy, s2
        MPYS    s3, hierarchy_wayz, s3
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
        EX      s5, walk_top
        STO     [s5], s0
        BIM     walk_node
walk_leaf:
        RTOR    hierarchy_count, regions_left
        RTOR    hierarchy_regions, region
        BIM     walk_next

; The s6 rays of near_bits become a set; s8 of them were tried.
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
        IX      s7, 64 * SET_PLACE
        LOD     [s7], s3
        IX      s7, 64 * (SET_END - SET_PLACE)
        LOD     [s7], s1
        EX      s0, walk_set
        STO     [s0], s1
        RTOR    s1, s5
        IX      s5, 64 * SET_SIZE
        ELEN    s5, 0
        ADDLEN  s5, s6, s5
        SHIFTI  s6, 6, s2
        set_take s3
        few_to_gather s6, s8, s0, walk_gather
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
        SUBX    s6, n, s0
        ADDLEN  aox, s0, ox
        ADDLEN  aoy, s0, oy
        ADDLEN  aoz, s0, oz
walk_narrowed:
        RTOR    s5, s7
        RTOR    s6, s5
        RTOR    s6, s8
        load_word walk_last, s6
        ELEN    s1, 6
        SWAP    [r0], ox, [s1]
        IX      s1, 64 * SET_PLACE
        ELEN    s1, SET_SIZE - SET_PLACE
        SWAP    [r0], s3, [s1]
        BIM     walk_below

walk_end:
        .ifdef  PAIRS
        EX      target, finish_pairs
        BSAVE   link_inner, [target]
        .endif

; The next region that is marked, of those with clear parts: against the queue.
walk_next_clear:
        EX      s1, walk_clear
        ELEN    s1, 2
        SWAP    [s1], s2, [r0]                  ; and s3
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
        SHIFTI  s5, 6, s7
        ADDX    s2, s7, s2
        IBXEQ   s5, r0, s3, walk_searched       ; none among these
        LOD     [s2], region
        STO     [s2], r0
        IX      s2, 64
        ADDX    s6, minus_one_index, s6
walk_searched:
        RTOR    s6, s4
        RTOR    s3, s6
        RTOR    s4, s3
        EX      s1, walk_clear
        ELEN    s1, 2
        SWAP    [r0], s2, [s1]
        IBXEQ   s5, r0, s6, walk_next_clear
        EX      s1, walk_set
        EX      s2, queue_set
        STO     [s1], s2
        ES      regions_left, 1
        ELEN    region, REGION_WORDS
        SWAP    [region], bound_x, [r0]
        ES      region_shadow, 1                ; not to be marked again
        BIM     walk_bound
        .endkernel
