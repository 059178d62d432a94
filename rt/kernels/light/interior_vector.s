; interior_vector.s - computes the bodies that contain the rays of a queue.  The
; formulas are in interior.s.

        .share  shape
        .regs   r40, in_table, in_base, in_per_base, in_full, in_per_full
        .regs   r45, in_levels, in_body, in_scale
        .endshare

; lx = S of the m rays, or -1.
        .kernel spawn
take_interiors:
        load_word queue_inside, s0
        VXTOV   [at], [s0], [lx]
        BIM     0, link_inner

; In:  lx = S, facing, hits0; spawn_index, spawn_inverted.
; Out: lx = S; ly = S', lz = e; v7 = w, if the scene has such mirrors.  Changes
; v0-v4, hits1-hits3.
find_interiors:
        find_entering
        EX      s0, scene_interiors
        load_from s0, INTERIORS_OF_SIZE, in_table
        load_field P_INTERIOR, in_body
        CMPLTV  [lx], r0, [hits1]
        if_none hits1, s0, interiors_known
        ANDB    [hits1], [hits2], [hits3]
        VTOV    r0, [lx] ? [hits3]
        ANDNB   [hits1], [hits2], [hits3]
        VTOV    in_body, [lx] ? [hits3]
interiors_known:
        last_of lx, v0, v1
        CMPEQV  [v1], in_body, [hits1]          ; the rays that leave
        index_of v1, v2
        DIVSV   [v2], spawn_index, [lz]
        .if     GLOSS
        DIVSV   spawn_index, [v2], [v7]
        .endif
        CFPEQ   in_full, r0, interiors_limit
        drop_first lx, v2
        line    v2, in_base, in_body, ly
        BIM     interiors_come
interiors_limit:
        line    lx, in_base, in_body, ly
interiors_come:
        if_none hits1, s0, interiors_under
        VTOV    [v0], [ly] ? [hits1]
        .if     GLOSS
        VTOV    [lz], [v7] ? [hits1]
        CMPEQV  [v0], r0, [hits3]
        ANDB    [hits3], [hits1], [hits3]
        VTOV    spawn_reciprocal, [v7] ? [hits3]
        .endif
        last_of v0, v2, v3
        index_of v3, v2
        DIVSV   spawn_index, [v2], [v2]
        VTOV    [v2], [lz] ? [hits1]

; Searches for the body among the previous ones: v0 = the bodies not yet
; searched, in_scale = B^k, where k is the number of divisions.
interiors_under:
        RTOR    in_base, in_scale
interiors_deeper:
        CMPNEV  [v0], r0, [hits3]
        if_none hits3, s0, interiors_near
        last_of v0, v2, v3
        CMPEQV  [v3], in_body, [hits3]
        if_none hits3, s0, interiors_deeper_next
        SUBNV   [v2], [v0], [v3]
        LINKV
        MPYSV   [v3], in_scale, [v3]
        ADDNV   [v3], [lx], [v3]
        VTOV    [v3], [ly] ? [hits3]
        .if     GLOSS
        VTOV    [lz], [v7] ? [hits3]
        .endif
        VTOV    one, [lz] ? [hits3]
interiors_deeper_next:
        VTOV    [v2], [v0]
        MPYS    in_scale, in_base, in_scale
        BIM     interiors_deeper

interiors_near:
        SUBNV   [lz], one, [v0]
        ABSV    [v0], [v0]
        CMPLTV  [v0], checker_shift, [hits1]
        VTOV    one, [lz] ? [hits1]
        BIM     0, link_inner
        .endkernel
