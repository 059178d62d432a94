; sparse_vector.s - processes a tree node that few of the current rays come
; near.
;
; These rays are gathered, and only they are current for everything below the
; node. Below it no further gathering takes place. Kernels intersect these rays.
; The crossings of a primitive are then expanded to all rays: misses, except for
; the gathered rays.
;
; In:  the node; near_bits, s0 of them; the current rays.
; Out: the crossings of the leaves below it; the active leaves and branches.
; Source: derived here.

        .share  phase
        .reg    link_sparse, r188
        .endshare

; The largest number of crossings of a gathered ray.
        .if     MAX_CROSSINGS > 3 * PATCH_CROSSINGS
        .equ    SPARSE_CROSSINGS, MAX_CROSSINGS
        .else
        .equ    SPARSE_CROSSINGS, 3 * PATCH_CROSSINGS
        .endif

        .data
sparse_outer:   .word 0                 ; rays before gathering, 0 if not done
sparse_saved:   .space 9                ; wox .. wlower, near_limit, nodes_end
sparse_rays:    .word 0                 ; descriptor: places of gathered rays
sparse_first:   .word 0                 ; address of the primitive's crossings
        .align  64
        .if     INTERIORS
sparse_least:   .space 2 * QUEUE        ; as passed_store
        .endif
sparse_store:   .space (8 + SPARSE_CROSSINGS) * QUEUE ; positions, rays, limits,
                                                   ; crossings
        .code

        .macro  gather_sparse vector, number
        describe s3, sparse_store + 64 * QUEUE * \number, s9
        VXTOV   [s2], [\vector], [s3]
        RTOR    s3, \vector
        .endm

; Stores the next vector of the region's crossings: those of the gathered rays,
; and `none` for the other rays.
        .macro  expand_sparse vector, none
        VTOV    \none, [slot]
        VTOVX   [s4], [\vector], [slot]
        ADDX    slot, slot_size, slot
        .endm

        .kernel bound
node_sparse:
        RTOR    s0, s9
        store_word near, sparse_outer, s3
        store_words wox, 7, sparse_saved, s3    ; wox .. wlower
        IX      s3, 64 * 7
        STO     [s3], near_limit
        STO     [s3, one_index], nodes_end
        RTOR    node_after, nodes_end
        EX      s2, sparse_store
        CPSV    [iota], [s2] ? [near_bits]
        store_word s2, sparse_rays, s3
        gather_sparse wdx, 4
        gather_sparse wdy, 5
        gather_sparse wdz, 6
        gather_sparse near_limit, 7
        change_length wo, wo, s9, near, s4
        IBXNE   from_one_point, r0, r0, sparse_gathered
        gather_sparse wox, 1
        gather_sparse woy, 2
        gather_sparse woz, 3
sparse_gathered:
        .if     INTERIORS
        load_word passed_current, s3
        IBXEQ   s3, r0, r0, sparse_passed_none
        describe s3, sparse_least, s9
        EX      s4, 64 * QUEUE
        VXTOV   [s2], [wlower], [s3]
        ADDX    wlower, s4, s5
        ADDX    s3, s4, s4
        VXTOV   [s2], [s5], [s4]
        RTOR    s3, wlower
        set_near s9
        ES      space, 0
        BIM     node_near
sparse_passed_none:
        .endif
        set_near s9
        call_routine take_least, link_inner
        BIM     node_near

; Everything below the node is done. The rays before gathering are current.
sparse_hit:
        store_word r0, sparse_outer, s3
        load_words sparse_saved, 7, wox, s3
        IX      s3, 64 * 7
        LOD     [s3], near_limit
        LOD     [s3, one_index], nodes_end
        ES      space, 0
        set_near s9
        BIM     node_next
        .endkernel

        .kernel call
sparse_leaf:
        store_word leaf_first_event, sparse_first, s3
        RTOR    primitive, shape_at
        call_routine sparse_kernel, link_sparse
        load_field P_STATE_KERNEL, s0
        IBXEQ   s0, r0, r0, node_next
        load_field P_FIRST_STATE, s0
        store_word s0, sparse_first, s3
        address_of primitive, P_STATE_KERNEL, shape_at
        call_routine sparse_kernel, link_sparse
        BIM     node_next

; Calls the kernel at shape_at for the gathered rays and stores its crossings
; from sparse_first on.
sparse_kernel:
        describe tin, sparse_store + 64 * QUEUE * 8, near
        EX      s3, 64 * QUEUE
        ADDX    tin, s3, tout
        ADDX    tout, s3, tin2
        ADDX    tin2, s3, tout2
        ADDX    tout2, s3, tin3
        ADDX    tin3, s3, tout3
        set_rays wox, woy, woz, wdx, wdy, wdz, wlower
        RTOR    shape_at, s4
        load_field P_SEGMENTS, segments_wanted
        RTOR    s4, shape_at
        IBXNE   segments_wanted, r0, r0, sparse_solid
        find_parameters
sparse_solid:
        call_kernel
        load_record P_SEGMENTS, 4, leaf_segments
        EX      slot_size, 64 * CROSSING_SIZE
        load_word sparse_outer, s1
        load_word sparse_first, s4
        ADDLEN  s4, s1, slot
        load_word sparse_rays, s4
        IBXEQ   leaf_segments, r0, r0, sparse_patch
        expand_sparse tin, big
        expand_sparse tout, minus_big
        IBXEQ   leaf_segments, r0, one_index, sparse_expanded
        expand_sparse tin2, big
        expand_sparse tout2, minus_big
        ES      s1, 2
        IBXEQ   leaf_segments, r0, s1, sparse_expanded
        expand_sparse tin3, big
        expand_sparse tout3, minus_big
        .if     MAX_CROSSINGS > 6
        RTOR    tout3, s3
        ES      s1, -3
        ADDX    leaf_segments, s1, leaf_segments
sparse_more:
        IBXEQ   leaf_segments, r0, r0, sparse_expanded
        EX      s1, 64 * QUEUE
        ADDX    s3, s1, s3
        expand_sparse s3, big
        ADDX    s3, s1, s3
        expand_sparse s3, minus_big
        IBXNE   leaf_segments, minus_one_index, r0, sparse_more, leaf_segments
        .endif
sparse_expanded:
        BIM     0, link_sparse
sparse_patch:
        IBXNE   shadows, r0, r0, sparse_crossing
        ES      leaf_events, 3 * PATCH_CROSSINGS ; with its parameters
sparse_crossing:
        expand_sparse tin, big
        ADDX    tin, slot_size, tin
        IBXNE   leaf_events, minus_one_index, r0, sparse_crossing, leaf_events
        BIM     0, link_sparse
        .endkernel
