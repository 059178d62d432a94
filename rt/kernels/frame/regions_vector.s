; regions_vector.s - intersects the rays of a queue with each region.
;
; A region is a primitive or a Boolean tree of primitives (records.s). Rays that
; come near it are compressed, unless they are most of the queue. If the region
; has a box, the rays near the box are compressed again (miss_box_vector.s). The
; kernels compute the segments inside the region's primitives.
;
; simple_hit processes the segments of a simple region, walk_tree those of
; others. Both continue at walk_skip.
;
; In:  the queue's rays, their limits in nearest, shadows.
;
; Regions of the hierarchy are below its nodes (hierarchy_vector.s). The other
; regions come first, in the order of the scene. If hits have equal
; distances, the one on the primitive with the lowest number counts as the
; nearest, for any order of the regions.
; Source: the paper's queue, one object against all rays in turn; the project's
; notes on ray tracing, 4.1.

; With HIDDEN, rays skip the regions that are hidden from their class
; (R_HIDDEN_FROM). Shadow rays skip none.

; A region, while its bound is tested.
        .share  shape
        .regs   r61, region_flags, region_shadow, region_nodes
        .regs   r64, region_nodes_end, region_first
        .endshare
        .equ    REGION_WORDS, R_FIRST + 1

        .reg    link_walk, r133

        .if     HIDDEN
        .data
hidden_class:   .word 0                 ; class of rays that do not see the
                                        ; region, an integer; 0: all rays see it
        .code
        .endif

; Rays are compressed if they are fewer than SPARSE / SPARSE_OF of all. With
; more rays compressing does not pay.
        .equ    SPARSE, 3
        .equ    SPARSE_OF, 4

        .macro  if_sparse count, all, few
        ES      s0, SPARSE_OF
        MPYX    \count, s0, s0
        ES      s1, SPARSE
        MPYX    \all, s1, s1
        IBXLT   s0, r0, s1, \few
        .endm

        .macro  call_kernel
        load_from shape_at, 2, target           ; target, inner_kernel
        BSAVE   link_kernel, [target]
        .endm

        .kernel visible
walk_regions:
        RTOR    link, link_walk
        .endkernel

        .kernel bound
        call_routine begin_walk, link_inner
        IBXEQ   regions_left, r0, r0, walk_pop
walk_next:
        load_from region, REGION_WORDS, bound_x
        .if     HIDDEN
        IBXEQ   shadows, r0, r0, walk_hidden
        .else
        IBXEQ   shadows, r0, r0, walk_bound
        .endif
        IBXEQ   region_shadow, r0, r0, walk_skip
        IBXEQ   region_shadow, r0, one_index, walk_bound
        load_word walk_set, s0
        EX      s1, queue_set
        IBXEQ   s0, r0, s1, walk_mark
walk_bound:
        call_routine load_set, link_inner
        RTOR    s8, s0
        CFPGE   bound_r, big, walk_near
        call_routine test_queue_bound, link_inner
        IBXEQ   s0, r0, r0, walk_skip
walk_near:
        RTOR    s0, s6
        .if     HIDDEN
        IBXEQ   shadows, r0, r0, walk_compress
        .else
        IBXEQ   shadows, r0, r0, walk_take
        .endif
        IBXNE   region_shadow, r0, one_index, walk_mark
walk_take:
        EX      target, take_some
        if_sparse  s6, s8, walk_taken
        EX      target, take_all
walk_taken:
        BSAVE   link_inner, [target]
        IBXEQ   region_flags, r0, one_index, walk_simple
        IBXEQ   region_flags, r0, r0, walk_nodes
        call_routine take_box_hits, link_inner
        IBXEQ   s6, r0, r0, walk_skip
        ES      s0, REGION_BOXED
        IBXNE   region_flags, r0, s0, walk_simple
        BIM     walk_nodes
walk_mark:
        load_of region, R_CLEAR, s1
        STO     [s1], region
walk_skip:
        IX      region, 64 * R_SIZE
        IBXNE   regions_left, minus_one_index, r0, walk_next, regions_left
        BIM     walk_pop
walk_done:
        BIM     0, link_walk

        .if     HIDDEN
; Skips a region that no ray of the queue sees.
walk_hidden:
        load_of region, R_HIDDEN_FROM, s0
        load_word queue_class_sum, s1
        AND     s0, s1, s2
        store_word s2, hidden_class, s3
        IBXEQ   s2, r0, s1, walk_skip
        BIM     walk_bound

; In a queue of both classes, compresses the rays that come near the region and
; are of the class that sees it.
walk_compress:
        load_word hidden_class, s1
        IBXEQ   s1, r0, r0, walk_take
        load_word walk_set, s2
        IX      s2, 64 * SET_INDEX
        LOD     [s2], s2
        load_word queue_classes, s3
        describe bound_g0, bound_store, s8
        describe bound_bits, bound_bit_store, s8
        describe near_bits, queue_bits, s8
        VXTOV   [s2], [s3], [bound_g0]
        CMPNEV  [bound_g0], s1, [bound_bits]
        CFPGE   bound_r, big, walk_unbound
        ANDB    [near_bits], [bound_bits], [bound_bits]
walk_unbound:
        ORB     [bound_bits], [bound_bits], [near_bits]
        if_none near_bits, s6, walk_skip
        EX      target, take_some
        IBXNE   s6, r0, s8, walk_taken
        EX      target, take_all
        BIM     walk_taken
        .endif

walk_simple:
        .endkernel
        .kernel call
        RTOR    region_first, primitive
        set_rays wox, woy, woz, wdx, wdy, wdz, wlower
        describe tin, found_store, near
        describe tout, found_store + 64 * QUEUE, near
        ES      segments_wanted, 1
        RTOR    primitive, shape_at
        call_kernel
        BIM     simple_hit
        .endkernel
