; invisible_vector.s - the visible crossings of an invisible primitive: none.
;
; In:  near; the primitive's record.
; Out: tin, tout and the vectors after them, P_SEGMENTS times (of a mesh once):
;      misses, big.
; The primitive only cuts others. P_STATE_KERNEL computes its segments.
; Source: derived here, for clipped_by.

        .kernel visible
invisible:
        .if     MESH_CROSSINGS
        load_field P_EVENTS, s1
        .else
        load_field P_SEGMENTS, s1
        ADDX    s1, s1, s1
        .endif
        RTOR    tin, s2
        EX      s0, 64 * CROSSING_SIZE
invisible_next:
        VTOV    big, [s2]
        ADDX    s2, s0, s2
        IBXNE   s1, minus_one_index, r0, invisible_next, s1
        BIM     0, link_kernel
        .endkernel
