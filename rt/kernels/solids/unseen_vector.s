; unseen_vector.s - the crossings that can be seen of a primitive that cuts others
; and is not seen itself: none.
;
; In:  near; the primitive's record.
; Out: tin, tout and what stands behind them, P_SEGMENTS times (of a mesh
;      once): misses, big.  What is inside of it P_STATE_KERNEL tells.
; Source: derived here, for clipped_by.

        .kernel visible
unseen:
        .if     MESH_CROSSINGS
        load_field P_EVENTS, s1
        .else
        load_field P_SEGMENTS, s1
        ADDX    s1, s1, s1
        .endif
        RTOR    tin, s2
        EX      s0, 64 * CROSSING_SIZE
unseen_next:
        VTOV    big, [s2]
        ADDX    s2, s0, s2
        IBXNE   s1, minus_one_index, r0, unseen_next, s1
        BIM     0, link_kernel
        .endkernel
