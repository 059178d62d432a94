; few_vector.s - a primitive of a tree that few of the rays at hand come near.
;
; They are gathered, and its kernel meets them alone; then its crossings are
; those of all rays at hand again: misses, but where the few have any.
;
; In:  node_primitive; near_bits, s0 of them; the rays at hand.
; Out: the primitive's crossings; P_AT_HAND.
; Source: derived here.

; Where these registers' own stand meanwhile: few_saved.
        .share  walk
        .regs   r38, leaf_first, few_at
        .endshare
        .share  phase
        .reg    link_few, r188
        .endshare

; So many crossings of them, at the most.
        .if     CROSSINGS_MOST > 3 * PATCH_CROSSINGS
        .equ    FEW_CROSSINGS, CROSSINGS_MOST
        .else
        .equ    FEW_CROSSINGS, 3 * PATCH_CROSSINGS
        .endif

        .data
few_saved:      .space 9
few_outer:      .word 0                 ; how many rays were at hand
        .align  64
few_store:      .space (7 + FEW_CROSSINGS) * QUEUE ; places, rays, crossings
        .code

        .macro  gather_few vector, number
        describe s3, few_store + 64 * QUEUE * \number, s9
        VXTOV   [few_at], [\vector], [s3]
        RTOR    s3, \vector
        .endm

; The next vector of the region's crossings: misses, and what the few have.
        .macro  spread_few vector, none
        VTOV    \none, [slot]
        VTOVX   [few_at], [\vector], [slot]
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
        ELEN    s3, 2
        SWAP    [r0], node_at, [s3]             ; and nodes_end
        EX      few_at, few_store
        CPSV    [iota], [few_at] ? [near_bits]
        gather_few wdx, 4
        gather_few wdy, 5
        gather_few wdz, 6
        SUBX    s9, near, s4
        ADDLEN  wox, s4, wox
        ADDLEN  woy, s4, woy
        ADDLEN  woz, s4, woz
        IBXNE   from_one_point, r0, r0, few_gathered
        gather_few wox, 1
        gather_few woy, 2
        gather_few woz, 3
few_gathered:
        set_near s9
        EX      target, take_least
        BSAVE   link_inner, [target]
        .endkernel

        .kernel call
        RTOR    node_primitive, primitive
        store_field P_AT_HAND, one_index
        load_field P_FIRST_EVENT, leaf_first
        RTOR    primitive, shape_at
        EX      target, few_kernel
        BSAVE   link_few, [target]
        load_field P_STATE_KERNEL, s0
        IBXEQ   s0, r0, r0, few_end
        load_field P_FIRST_STATE, leaf_first
        RTOR    primitive, shape_at
        IX      shape_at, 64 * P_STATE_KERNEL
        EX      target, few_kernel
        BSAVE   link_few, [target]
few_end:
        EX      s3, few_saved
        ELEN    s3, 7
        SWAP    [s3], wox, [r0]
        IX      s3, 64 * 7
        ELEN    s3, 2
        SWAP    [s3], node_at, [r0]
        ES      space, 0
        load_word few_outer, s9
        set_near s9
        BIM     node_next

; The kernel that shape_at says, for the few; its crossings from leaf_first on.
few_kernel:
        describe tin, few_store + 64 * QUEUE * 7, near
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
        MPYX    leaf_first, slot_size, s1
        load_word scene_crossings, slot
        ADDX    slot, s1, slot
        load_word few_outer, s1
        ADDLEN  slot, s1, slot
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
        .if     CROSSINGS_MOST > 6
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
