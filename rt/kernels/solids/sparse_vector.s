; sparse_vector.s - a node of a tree that few of the rays at hand come near.
;
; They are gathered, and they alone are at hand for all that is below it, where
; nothing is gathered again.  Kernels meet them; then the crossings of a primitive are
; those of all rays again: misses, but where the few have any.
;
; In:  the node; near_bits, s0 of them; the rays at hand.
; Out: the crossings of what is below it; the leaves and branches at hand.
; Source: derived here.

        .share  phase
        .reg    link_few, r188
        .endshare

; The largest number of their crossings.
        .if     MAX_CROSSINGS > 3 * PATCH_CROSSINGS
        .equ    FEW_CROSSINGS, MAX_CROSSINGS
        .else
        .equ    FEW_CROSSINGS, 3 * PATCH_CROSSINGS
        .endif

        .data
few_outer:      .word 0                 ; how many rays were at hand; 0: they are
few_saved:      .space 9                ; wox .. wlower, near_limit, nodes_end
few_places:     .word 0                 ; descriptor: where the few were
few_first:      .word 0                 ; address of the primitive's crossings
        .align  64
        .if     INTERIORS
few_least:      .space 2 * QUEUE        ; as passed_store
        .endif
few_store:      .space (8 + FEW_CROSSINGS) * QUEUE ; places, rays, limits, crossings
        .code

        .macro  gather_few vector, number
        describe s3, few_store + 64 * QUEUE * \number, s9
        VXTOV   [s2], [\vector], [s3]
        RTOR    s3, \vector
        .endm

; The next vector of the region's crossings: misses, and what the few have.
        .macro  spread_few vector, none
        VTOV    \none, [slot]
        VTOVX   [s4], [\vector], [slot]
        ADDX    slot, slot_size, slot
        .endm

        .kernel bound
node_few:
        RTOR    s0, s9
        EX      s3, few_outer
        STO     [s3], near
        EX      s3, few_saved
        ELEN    s3, 7
        SWAP    [r0], wox, [s3]                 ; .. wlower
        IX      s3, 64 * 7
        STO     [s3], near_limit
        STO     [s3, one_index], nodes_end
        RTOR    node_behind, nodes_end
        EX      s2, few_store
        CPSV    [iota], [s2] ? [near_bits]
        EX      s3, few_places
        STO     [s3], s2
        gather_few wdx, 4
        gather_few wdy, 5
        gather_few wdz, 6
        gather_few near_limit, 7
        SUBX    s9, near, s4
        ADDLEN  wox, s4, wox
        ADDLEN  woy, s4, woy
        ADDLEN  woz, s4, woz
        IBXNE   from_one_point, r0, r0, few_gathered
        gather_few wox, 1
        gather_few woy, 2
        gather_few woz, 3
few_gathered:
        .if     INTERIORS
        load_word passed_at_hand, s3
        IBXEQ   s3, r0, r0, few_passed_none
        describe s3, few_least, s9
        EX      s4, 64 * QUEUE
        VXTOV   [s2], [wlower], [s3]
        ADDX    wlower, s4, s5
        ADDX    s3, s4, s4
        VXTOV   [s2], [s5], [s4]
        RTOR    s3, wlower
        set_near s9
        ES      space, 0
        BIM     node_near
few_passed_none:
        .endif
        set_near s9
        EX      target, take_least
        BSAVE   link_inner, [target]
        BIM     node_near

; All that is below the node is met; s9 rays are at hand again.
few_met:
        EX      s3, few_outer
        STO     [s3], r0
        EX      s3, few_saved
        ELEN    s3, 7
        SWAP    [s3], wox, [r0]
        IX      s3, 64 * 7
        LOD     [s3], near_limit
        LOD     [s3, one_index], nodes_end
        ES      space, 0
        set_near s9
        BIM     node_next
        .endkernel

        .kernel call
few_leaf:
        EX      s3, few_first
        STO     [s3], leaf_first_event
        RTOR    primitive, shape_at
        EX      target, few_kernel
        BSAVE   link_few, [target]
        load_field P_STATE_KERNEL, s0
        IBXEQ   s0, r0, r0, node_next
        load_field P_FIRST_STATE, s0
        EX      s3, few_first
        STO     [s3], s0
        RTOR    primitive, shape_at
        IX      shape_at, 64 * P_STATE_KERNEL
        EX      target, few_kernel
        BSAVE   link_few, [target]
        BIM     node_next

; The kernel that shape_at says, for the few; its crossings from few_first on.
few_kernel:
        describe tin, few_store + 64 * QUEUE * 8, near
        EX      s3, 64 * QUEUE
        ADDX    tin, s3, tout
        ADDX    tout, s3, tin2
        ADDX    tin2, s3, tout2
        ADDX    tout2, s3, tin3
        ADDX    tin3, s3, tout3
        look_at_rays wox, woy, woz, wdx, wdy, wdz, wlower
        RTOR    shape_at, s4
        load_field P_SEGMENTS, segments_wanted
        RTOR    s4, shape_at
        IBXNE   segments_wanted, r0, r0, few_solid
        find_parameters
few_solid:
        call_kernel
        load_record P_SEGMENTS, 4, leaf_segments
        EX      slot_size, 64 * CROSSING_SIZE
        load_word few_outer, s1
        load_word few_first, s4
        ADDLEN  s4, s1, slot
        load_word few_places, s4
        IBXEQ   leaf_segments, r0, r0, few_patch
        spread_few tin, big
        spread_few tout, minus_big
        IBXEQ   leaf_segments, r0, one_index, few_spread
        spread_few tin2, big
        spread_few tout2, minus_big
        ES      s1, 2
        IBXEQ   leaf_segments, r0, s1, few_spread
        spread_few tin3, big
        spread_few tout3, minus_big
        .if     MAX_CROSSINGS > 6
        RTOR    tout3, s3
        ES      s1, -3
        ADDX    leaf_segments, s1, leaf_segments
few_more:
        IBXEQ   leaf_segments, r0, r0, few_spread
        EX      s1, 64 * QUEUE
        ADDX    s3, s1, s3
        spread_few s3, big
        ADDX    s3, s1, s3
        spread_few s3, minus_big
        IBXNE   leaf_segments, minus_one_index, r0, few_more, leaf_segments
        .endif
few_spread:
        BIM     0, link_few
few_patch:
        IBXNE   shadows, r0, r0, few_crossing
        ES      leaf_events, 3 * PATCH_CROSSINGS ; its parameters, too
few_crossing:
        spread_few tin, big
        ADDX    tin, slot_size, tin
        IBXNE   leaf_events, minus_one_index, r0, few_crossing, leaf_events
        BIM     0, link_few
        .endkernel
