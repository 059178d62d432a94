; nearest_vector.s - finds the nearest hits of a queue.
;
; In a simple region, the crossing is tin if that is beyond the ray's least
; distance, else tout. It is a hit if it is beyond the least distance and before
; the ray's limit. In other regions the crossings are examined in order
; (visible_vector.s).
;
; find_nearest: In: the queue's rays.  Out: nearest, nearest_primitive (0:
; none); hit_s,
;               hit_t on patches.
; simple_hit:   In: tin, tout of the current rays, and of a shadow ray its
;               limit; found, of other rays.  Out: as find_nearest; for a
;               shadow ray nearest = minus_big.
; Source: the paper.

; With KEYS, nearest holds the least key so far: the distance of a hit plus
; P_TIE_OFFSET times k_delta. depth_store holds the distance of this hit
; (docs/solids.md).

; Hits: positions in the queue, distances, primitives.
        .share  crossings
        .regs   r107, taken_at, taken_distance, taken_primitive
        .if     KEYS
        .reg    taken_depth, r110
        .endif
        .endshare

        .data
first_material: .word 1                 ; address of the material hit last, or 1
        .if     KEYS
taken_store:    .space 4 * QUEUE
        .else
taken_store:    .space 3 * QUEUE
        .endif
found_bits:     .space 3 * QUEUE_BIT_WORDS
        .code

        .macro  take_found vector, into, number, bits
        EX      \into, taken_store + 64 * QUEUE * \number
        CPSV    [\vector], [\into] ? [\bits]
        .endm

        .macro  scatter_depth distance
        .if     KEYS
        describe s0, depth_store, n
        VTOVX   [taken_at], [\distance], [s0]
        .endif
        .endm

; Adds the primitive's material to the list of those that rays of the queue hit.
        .macro  mark_tested
        load_record P_MATERIAL, 2, s2               ; P_MATERIAL, P_TESTED
        IBXEQ   s2, r0, primitive, mark_own\@
        address_of s2, P_SHARED, s3
        STO     [s3], one_index
        IX      s3, 64 * (P_TESTED - P_SHARED)
        LOD     [s3], s3
mark_own\@:
        IBXNE   s3, r0, r0, marked\@
        EX      s3, first_material
        LOD     [s3], s4
        STO     [s3], s2
        IX      s2, 64 * P_TESTED
        STO     [s2], s4
marked\@:
        .endm

        .kernel visible
find_nearest:
        load_word k_far, s0
        VTOV    s0, [nearest]
        VTOV    r0, [nearest_primitive]
        .if     KEYS
        describe s1, depth_store, n
        VTOV    s0, [s1]
        .endif
        ES      shadows, 0
        EX      found, found_nearest
        BIM     walk_regions

simple_hit:
        CMPLTV  [wlower], [tin], [bits0]
        MASKV   [tin], [tout], [w0] ? [bits0]
        CMPLTV  [wlower], [w0], [bits0]
        IBXNE   shadows, r0, r0, simple_stops
        keep_where CMPGEV, [near_limit], [w0], bits0, bits1
        if_none bits0, s0, walk_skip
        load_record P_ID, 2, identity
        .if     SIMPLE_YIELDS
        RTOR    w0, s5                          ; keys
        load_field P_TIE_OFFSET, s6             ; their distance from w0
        CFPEQ   s6, r0, simple_compared
        load_word k_delta, s0
        MPYS    s6, s0, s6
        RTOR    w2, s5
        ADDNV   [w0], s6, [s5]
        keep_where CMPGEV, [near_limit], [s5], bits0, bits1
        if_none bits0, s0, walk_skip
simple_compared:
        CMPEQV  [s5], [near_limit], [bits1]
        .else
        CMPEQV  [w0], [near_limit], [bits1]
        .endif
        ANDB    [bits0], [bits1], [bits1]
        if_none bits1, s1, simple_nearer
        VXTOV   [ray_index], [nearest_primitive], [w1]
        keep_where CMPGEV, identity, [w1], bits1, bits2
        XORB    [bits0], [bits1], [bits0]
        if_none bits0, s0, walk_skip
simple_nearer:
        region_took_hits
        IBXEQ   near, r0, n, simple_all
        take_found ray_index, taken_at, 0, bits0
        mark_tested
        take_found w0, taken_distance, 1, bits0
        .if     SIMPLE_YIELDS
        scatter_depth taken_distance
        CFPEQ   s6, r0, simple_scatter
        ADDNV   [taken_distance], s6, [taken_distance]
simple_scatter:
        .endif
        VTOVX   [taken_at], [taken_distance], [nearest]
        VTOVX   [taken_at], identity, [nearest_primitive]
        .if     SIMPLE_YIELDS == 0
        scatter_depth taken_distance
        .endif
        IBXEQ   on_patch, r0, r0, walk_skip
        take_found patch_s, taken_distance, 1, bits0
        VTOVX   [taken_at], [taken_distance], [hit_s]
        take_found patch_t, taken_distance, 1, bits0
        VTOVX   [taken_at], [taken_distance], [hit_t]
        BIM     walk_skip

; All rays of the queue are current.
simple_all:
        mark_tested
        .if     SIMPLE_YIELDS
        VTOV    [s5], [nearest] ? [bits0]
        .else
        VTOV    [w0], [nearest] ? [bits0]
        .endif
        VTOV    identity, [nearest_primitive] ? [bits0]
        .if     KEYS
        describe s0, depth_store, n
        VTOV    [w0], [s0] ? [bits0]
        .endif
        IBXEQ   on_patch, r0, r0, walk_skip
        VTOV    [patch_s], [hit_s] ? [bits0]
        VTOV    [patch_t], [hit_t] ? [bits0]
        BIM     walk_skip

; Blocks shadow rays.
simple_stops:
        keep_where CMPLTV, [w0], [near_limit], bits0, bits1
        if_none bits0, s0, walk_skip
        region_took_hits
        IBXEQ   near, r0, n, simple_stops_all
        take_found ray_index, taken_at, 0, bits0
        VTOVX   [taken_at], minus_big, [nearest]
        BIM     walk_skip
simple_stops_all:
        VTOV    minus_big, [nearest] ? [bits0]
        BIM     walk_skip
        .endkernel
