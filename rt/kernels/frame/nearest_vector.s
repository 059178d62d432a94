; nearest_vector.s - what the rays of a queue meet first.
;
; Of a simple region the crossing is tin if that lies ahead of the ray's least
; distance, else tout; it counts if it is ahead and before the ray's limit.  Of
; the others the crossings are looked at in turn (visible_vector.s).
;
; find_nearest: In: the queue's rays.  Out: nearest, met (0: none);
;   hit_s, hit_t on patches.
; simple_met: In: tin, tout of the rays at hand, and for a ray to a light its
;   limit; found, of the others.  Out: the same; for a ray to a light nearest =
;   minus_big.
; Source: the paper.

; Where a hit goes: places, distances, primitives.
        .share  crossings
        .regs   r107, taken_at, taken_distance, taken_met
        .endshare

        .data
taken_store:    .space 3 * QUEUE
found_bits:     .space 3 * QUEUE_BIT_WORDS
        .code

        .macro  take_found vector, into, number, bits
        EX      \into, taken_store + 64 * QUEUE * \number
        CPSV    [\vector], [\into] ? [\bits]
        .endm

        .kernel visible
find_nearest:
        load_word k_far, s0
        VTOV    s0, [nearest]
        VTOV    r0, [met]
        ES      shadows, 0
        EX      found, found_nearest
        BIM     walk_regions

simple_met:
        CMPLTV  [wlower], [tin], [bits0]
        MASKV   [tin], [tout], [w0] ? [bits0]
        CMPLTV  [wlower], [w0], [bits0]
        IBXNE   shadows, r0, r0, simple_stops
        CMPGEV  [near_limit], [w0], [bits1]
        ANDB    [bits0], [bits1], [bits0]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, walk_skip
        load_record P_ID, 2, identity
        CMPEQV  [w0], [near_limit], [bits1]
        ANDB    [bits0], [bits1], [bits1]
        CNTOB   [bits1], s1
        IBXEQ   s1, r0, r0, simple_nearer
        VXTOV   [place], [met], [w1]
        CMPGEV  identity, [w1], [bits2]
        ANDB    [bits1], [bits2], [bits1]
        XORB    [bits0], [bits1], [bits0]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, walk_skip
simple_nearer:
        region_took_hits
        IBXEQ   near, r0, n, simple_all
        take_found place, taken_at, 0, bits0
        store_field P_MET, one_index
        take_found w0, taken_distance, 1, bits0
        VTOVX   [taken_at], [taken_distance], [nearest]
        VTOVX   [taken_at], identity, [met]
        IBXEQ   on_patch, r0, r0, walk_skip
        take_found patch_s, taken_distance, 1, bits0
        VTOVX   [taken_at], [taken_distance], [hit_s]
        take_found patch_t, taken_distance, 1, bits0
        VTOVX   [taken_at], [taken_distance], [hit_t]
        BIM     walk_skip

; The rays at hand are all of the queue.
simple_all:
        store_field P_MET, one_index
        VTOV    [w0], [nearest] ? [bits0]
        VTOV    identity, [met] ? [bits0]
        IBXEQ   on_patch, r0, r0, walk_skip
        VTOV    [patch_s], [hit_s] ? [bits0]
        VTOV    [patch_t], [hit_t] ? [bits0]
        BIM     walk_skip

; Rays to a light are stopped.
simple_stops:
        CMPLTV  [w0], [near_limit], [bits1]
        ANDB    [bits0], [bits1], [bits0]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, walk_skip
        region_took_hits
        IBXEQ   near, r0, n, simple_stops_all
        take_found place, taken_at, 0, bits0
        VTOVX   [taken_at], minus_big, [nearest]
        BIM     walk_skip
simple_stops_all:
        VTOV    minus_big, [nearest] ? [bits0]
        BIM     walk_skip
        .endkernel
