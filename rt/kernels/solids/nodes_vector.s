; nodes_vector.s - the crossings of the rays at hand with a region's primitives.
;
; The nodes stand in preorder.  A node whose bounding sphere no ray comes near
; is passed over with all that is below it; those primitives are not at hand,
; and nothing looks at their crossings.  Of the others the kernels write
; into the region's crossings directly: tin, tout .. are descriptors of vectors
; there.
;
;   closed shape    P_SEGMENTS times in, out from P_FIRST_STATE on
;   open shape      likewise those of the closed one; its own crossings
;                   from P_FIRST_EVENT on
;   patch           PATCH_CROSSINGS crossings, as many s, as many t from
;                   P_FIRST_EVENT on
;
; Where few come near a primitive those are gathered (few_vector.s), or what is
; needed leaves no others (span_vector.s).  Behind each primitive it goes on at
; node_met, with the segments in tin ..; behind all of them at walk_tree.
;
; Where something has been met before, crossings a little beyond the limits are
; looked for, too: of two regions at one distance the first primitive counts,
; which found_nearest decides.
;
; In:  region, the rays at hand.  Out: the crossings; P_AT_HAND.
; Source: derived here; the project's notes on ray tracing, 4.1.

; A primitive's part in a tree: the words from P_SEGMENTS on.
        .share  scratch
        .regs   r247, leaf_at_hand, leaf_segments, leaf_events, leaf_first_state
        .reg    leaf_first_event, r251
        .reg    slot, r252
        .reg    slot_size, r253
        .endshare

; The region's primitives at hand, one after another; to next for the next one.
        .share  crossings
        .reg    first_leaf, r105
        .reg    leaf_count, r106
        .endshare

        .macro  leaves_begin
        RTOR    first_leaf, primitive
        RTOR    leaf_count, primitives_left
        .endm

        .macro  leaf_at_hand next
        RTOR    primitive, shape_at
        IX      shape_at, 64 * P_AT_HAND
        ELEN    shape_at, 5
        SWAP    [shape_at], leaf_at_hand, [r0]
        IBXEQ   leaf_at_hand, r0, r0, \next
        .endm

        .macro  leaves_next again
        IX      primitive, 64 * P_SIZE
        IBXNE   primitives_left, minus_one_index, r0, \again, primitives_left
        .endm

        .equ    CROSSING_SIZE, QUEUE

; The words of a node from its primitive on.
        .share  shape
        .regs   r61, node_primitive, node_behind, node_needed
        .endshare
        .equ    NODE_WORDS, N_NEEDED + 1
        .share  phase
        .reg    leaf_needed, r188
        .reg    least_culled, r187      ; smaller bounds are tested
        .endshare

; slot := descriptor of crossing number first, the next one slot_size on.
        .macro  find_slot first
        EX      slot_size, 64 * CROSSING_SIZE
        MPYX    \first, slot_size, s1
        load_word scene_crossings, slot
        ADDX    slot, s1, slot
        ADDLEN  slot, near, slot
        .endm

        .macro  next_slot into
        RTOR    slot, \into
        ADDX    slot, slot_size, slot
        .endm

; Where the parameters of a patch's crossings go, which are from tin on.
        .macro  find_parameters
        EX      s0, 64 * CROSSING_SIZE * PATCH_CROSSINGS
        ADDX    tin, s0, patch_s
        ADDX    patch_s, s0, patch_t
        ES      segments_wanted, PATCH_CROSSINGS / 2
        .endm

        .macro  find_segments first
        find_slot \first
        next_slot tin
        next_slot tout
        next_slot tin2
        next_slot tout2
        next_slot tin3
        next_slot tout3
        .endm

        .kernel bound
walk_nodes:
        IBXNE   shadows, r0, r0, walk_limited
        load_word walk_last, s0
        IBXEQ   s0, r0, r0, walk_limited
        load_word bound_more, s0
        describe s3, place_store + 64 * QUEUE, near
        MPYSV   [near_limit], s0, [s3]
        RTOR    s3, near_limit
walk_limited:
        RTOR    region_first, first_leaf
        RTOR    region_count, leaf_count
        RTOR    region_nodes, node_at
        RTOR    region_nodes_end, nodes_end
        leaves_begin
node_clear:
        store_field P_AT_HAND, r0
        leaves_next node_clear
        EX      target, begin_span
        BSAVE   link_inner, [target]
        ELEN    node_at, NODE_WORDS
        SWAP    [node_at], bound_x, [r0]
        MPYS    bound_r, half, least_culled
        BIM     node_near                       ; the region's own bound
node_next:
        IBXEQ   node_at, r0, nodes_end, walk_tree
        ELEN    node_at, NODE_WORDS
        SWAP    [node_at], bound_x, [r0]
        CFPGE   bound_r, least_culled, node_near
        look_at_rays wox, woy, woz, wdx, wdy, wdz, wlower
        RTOR    near, s8
        RTOR    near_limit, s9
        EX      target, test_bound
        BSAVE   link_inner, [target]
        IBXEQ   s0, r0, r0, node_far
        IBXEQ   node_primitive, r0, r0, node_near
        ADDX    s0, s0, s1
        ADDX    s1, s1, s1
        IBXGE   s1, r0, near, node_near
        IBXNE   node_needed, r0, r0, needed_few
        IX      node_at, 64 * N_SIZE
        BIM     node_few
node_far:
        IBXNE   node_needed, r0, r0, walk_skip
        RTOR    node_behind, node_at
        BIM     node_next
node_near:
        IX      node_at, 64 * N_SIZE
        IBXEQ   node_primitive, r0, r0, node_next
        RTOR    node_needed, leaf_needed
        .endkernel

        .kernel call
        RTOR    node_primitive, primitive
        store_field P_AT_HAND, one_index
        look_at_rays wox, woy, woz, wdx, wdy, wdz, wlower
        load_record P_SEGMENTS, 4, leaf_segments
        find_segments leaf_first_event
        RTOR    leaf_segments, segments_wanted
        IBXNE   leaf_segments, r0, r0, node_solid
        ES      leaf_needed, 0
        find_parameters
node_solid:
        RTOR    primitive, shape_at
        call_kernel
        load_field P_STATE_KERNEL, s0
        IBXEQ   s0, r0, r0, node_met
        load_record P_SEGMENTS, 4, leaf_segments
        find_segments leaf_first_state
        RTOR    leaf_segments, segments_wanted
        RTOR    primitive, shape_at
        IX      shape_at, 64 * P_STATE_KERNEL
        call_kernel
        BIM     node_met
        .endkernel
