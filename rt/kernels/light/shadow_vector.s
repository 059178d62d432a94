; shadow_vector.s - computes the light that reaches the hits of a queue.
;
; From each point that faces the light a ray goes to it.  A hit that is farther
; than k_shadow from both blocks it.  These rays form a queue of their own,
; which is intersected with the regions as any other.  A blocked ray gets a
; limit below every hit, and is no longer tested.  In a region with transparent
; parts the visible crossings are processed in order: a transparent primitive
; multiplies the light by its passing colour at the point, channel by channel,
; and the ray continues k_shadow after it (POV-Ray's rule).
;
; In:  hits3: the s8 points that face the light; v0: their distance from it; px
;      .., lx ..; ndotl; with areas shadows: the light, or the point of its
;      area, to which the rays go, and v0: their limits.
; Out: ndotl = 0 in the dark; tinted = 1 and tint_r .. for all hits if a
;      transparent surface is in the way of any.
; found_shadow: In: the results of walk_tree (visible_vector.s).  Out: nearest =
;      minus_big for blocked rays; the tints of the queue; visible_rays =
;      the rays that are finished in this region.
; Source: derived here; the distance is POV-Ray's SHADOW_TOLERANCE.

        .data
shadow_n:       .word 0                 ; saved n of the hits' queue
shadow_view:    .word 0
        .if     BEAMS
shadow_parallel: .word 0                ; 1: the rays have no common target
        .endif
        .align  64
shadow_store:   .space 7 * QUEUE        ; points, directions, limits
tint_store:     .space 3 * QUEUE        ; of the queue, then of all hits
hit_tint_store: .space 3 * QUEUE
        .code

; Vector number of the shadow rays, from a vector of the hits.
        .macro  shadow_vector vector, into, number
        EX      \into, shadow_store + 64 * QUEUE * \number
        CPSV    [\vector], [\into] ? [hits3]
        .endm

; Expands the transmitted light to all hits; unblocked hits get the light's
; colour.
        .macro  spread_tint tint, light, number
        describe s0, tint_store + 64 * QUEUE * \number, n
        describe \tint, hit_tint_store + 64 * QUEUE * \number, h
        MRGV    [s0], \light, [\tint] ? [hits3]
        .endm

; Multiplies channel number of the rays of taken_at by the transmitted colour, a
; number or a vector.
        .macro  tint_channel number, transmitted
        EX      s0, tint_store + 64 * QUEUE * \number
        VXTOV   [taken_at], [s0], [v1]
        MPYSV   [v1], \transmitted, [v1]
        VTOVX   [taken_at], [v1], [s0]
        .endm

        .macro  tint_begin light, number
        describe s0, tint_store + 64 * QUEUE * \number, n
        VTOV    \light, [s0]
        .endm

; Computes the points of the rays of taken_at at taken_distance.
        .macro  shadow_point o, d, p
        VXTOV   [taken_at], [\d], [v0]
        MPYSV   [taken_distance], [v0], [v1]
        VXTOV   [taken_at], [\o], [\p]
        ADDNV   [\p], [v1], [\p]
        .endm

        .kernel shadow
cast_shadows:
        RTOR    link, link_shadow
        add_to_counter rays_shadow, s8
        store_word n, shadow_n, shape_at
        store_word from_one_point, shadow_view, shape_at
        .if     BEAMS
        beam_shadows s1
        .endif
        .if     AREAS == 0
        end_before_light
        .endif
        IBXNE   s8, r0, h, shadows_of_some
        copy_three px, py, pz, aox, aoy, aoz
        copy_three lx, ly, lz, adx, ady, adz
        RTOR    v0, nearest
        BIM     shadows_cast
shadows_of_some:
        three   shadow_vector, px, py, pz, aox, aoy, aoz, 0, 1, 2
        three   shadow_vector, lx, ly, lz, adx, ady, adz, 3, 4, 5
        shadow_vector v0, nearest, 6
shadows_cast:
        RTOR    s8, n
        ES      from_one_point, 0
        .if     AREAS == 0
        RTOR    light_at, shadows
        .endif
        EX      found, found_shadow
        call_routine walk_regions, link
        load_light
        EX      s0, shade_descriptors
        load_from s0, SHADE_VECTORS, at
        describe ndotl, NDOTL_STORE, h
        describe near_bits, queue_bits, n
        CMPNEV  [nearest], minus_big, [near_bits]
        CNTOB   [near_bits], s0
        IBXEQ   s0, r0, n, shadows_none
        XORB    [hits0], [hits0], [hits0]
        MRGB    [near_bits], [hits0], [hits1] ? [hits3]
        VTOV    r0, [ndotl] ?! [hits1]
shadows_none:
        IBXEQ   tinted, r0, r0, shadows_done
        three   spread_tint, tint_r, tint_g, tint_b, light_r, light_g, light_b, 0, 1, 2
shadows_done:
        load_word shadow_n, n
        load_word shadow_view, from_one_point
        BIM     0, link_shadow

; Processes the hits of the shadow rays in a region.
found_shadow:
        region_took_hits
        load_of region, R_SHADOW, s0
        IBXNE   s0, r0, one_index, shadow_of_parts
        take_found ray_index, taken_at, 0, visible_rays
        VTOVX   [taken_at], minus_big, [nearest]
        BIM     0, link_kernel
shadow_of_parts:
        leaves_begin
shadow_leaf:
        load_leaf_record
        load_field P_ID, identity
        CMPEQV  [event_primitive], identity, [bits0]
        ANDB    [bits0], [visible_rays], [bits0]
        if_none bits0, m, shadow_next
        take_found ray_index, taken_at, 0, bits0
        load_field P_CLEAR, s0
        IBXNE   s0, r0, r0, shadow_clear
        VTOVX   [taken_at], minus_big, [nearest]
        BIM     shadow_next
shadow_clear:
        XORB    [visible_rays], [bits0], [visible_rays]
        take_found event, taken_distance, 1, bits0
        load_word k_shadow, s0
        ADDNV   [event], s0, [event] ? [bits0]
        IBXNE   tinted, r0, r0, shadow_tinted
        ES      tinted, 1
        load_light
        tint_begin light_r, 0
        tint_begin light_g, 1
        tint_begin light_b, 2
shadow_tinted:
        set_lanes m, at
        load_record P_TRANSMITTED, 8, sh0
        load_field P_PIGMENT, s0
        IBXNE   s0, r0, r0, shadow_checker
        tint_channel 0, sh0
        tint_channel 1, sh1
        tint_channel 2, sh2
        BIM     shadow_next
shadow_checker:
        three   shadow_point, aox, aoy, aoz, adx, ady, adz, px, py, pz
        .if     IMAGES
        EX      target, find_cells
        .else
        EX      target, find_checker
        .endif
        BSAVE   link_inner, [target]
        MASKV   sh4, sh0, [cr] ? [hits3]
        MASKV   sh5, sh1, [cg] ? [hits3]
        MASKV   sh6, sh2, [cb] ? [hits3]
        tint_channel 0, [cr]
        tint_channel 1, [cg]
        tint_channel 2, [cb]
shadow_next:
        leaves_next shadow_leaf
        BIM     0, link_kernel
        .endkernel
