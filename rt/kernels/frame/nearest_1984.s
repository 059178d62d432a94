; nearest_1984.s - finds the nearest hits of a queue in kernels mode.
;
; The vector kernels compute the crossings. The rest is done ray by ray.
;
; find_nearest: In: the queue's rays.  Out: nearest, nearest_primitive = the
; primitive's
;               record (0: none); hit_s, hit_t on patches.
; simple_hit:   In: the segments of the current rays in a simple region, in
;               found_store.
; walk_tree:    In: the crossings of the current rays with a region's
;               primitives.
;
; simple_hit and walk_tree update the results of find_nearest. For a shadow ray
; they set nearest = minus_big if it is blocked, and light_left to the
; transmitted light. Methods as in regions_scalar.s, shadow_scalar.s and
; trees_1984.s.

        .include "frame/trees_1984.s"

        .share  loop
        .reg    its_tie, r180           ; key of a hit in a simple region, less
                                        ; its distance
        .endshare

        .data
        .align 64
light_left:     .space 3 * QUEUE        ; transmitted light of each shadow ray
        .code

        .macro  load_segment index
        LOD     [from_in, \index], next_in
        LOD     [from_out, \index], next_out
        LOD     [from_limit, \index], next_limit
        .endm

        .macro  store_depth distance
        .if     KEYS
        EX      loop_work, depth_store
        STO     [loop_work, loop_ray_index], \distance
        .endif
        .endm

        .if     KEYS
; Sets tie to the product of the primitive's P_TIE_OFFSET and k_delta.
        .macro  load_tie primitive, tie
        address_of \primitive, P_TIE_OFFSET, loop_at
        LOD     [loop_at], segment_out
        load_words k_delta, 1, ray_limit
        MPYS    segment_out, ray_limit, \tie
        .endm
        .endif

; Accepts a hit that is nearer than the ray's hit, or equally near and on an
; earlier primitive.
        .macro  take_nearer distance, taken
        CFPLT   \distance, loop_work, \taken
        CFPNE   \distance, loop_work, tree_skip
        LOD     [to_nearest_primitive, loop_ray_index], loop_work
        IBXGE   w_out, r0, loop_work, tree_skip
\taken:
        STO     [to_nearest, loop_ray_index], \distance
        .endm

        .kernel visible
find_nearest:
        load_word k_far, s1
        VTOV    s1, [nearest]
        VTOV    r0, [nearest_primitive]
        .if     KEYS
        describe s0, depth_store, n
        VTOV    s1, [s0]
        .endif
        ES      shadows, 0
        BIM     walk_regions

simple_hit:
        pass_rays
        to_scalar
        load_words operands, SIMPLE_OPERANDS, to_nearest
        RTOR    near, loop_count
        ES      loop_index, 0
        LOD     [from_least], w_lower
        find_patch its_primitive
        .if     SIMPLE_YIELDS
        RTOR    r0, its_tie
        IBXNE   to_lights, r0, r0, simple_begin
        load_tie its_primitive, its_tie
simple_begin:
        .endif
        EX      from_in, found_store
        EX      from_out, found_store + 64 * QUEUE
        load_segment loop_index
simple_next:
        RTOR    next_in, segment_in
        RTOR    next_out, segment_out
        RTOR    next_limit, ray_limit
        ADDX    loop_index, m_index_one, loop_work
        load_segment loop_work                  ; loads the next ray's early
        .if     INTERIORS
        LOD     [from_least, loop_index], w_lower
        .endif
        CFPGE   w_lower, segment_in, simple_second
simple_ahead:
        .if     SIMPLE_YIELDS
        RTOR    segment_in, segment_out         ; distance
        ADDN    segment_in, its_tie, segment_in ; key
        .endif
        CFPGE   segment_in, ray_limit, simple_tie
simple_taken:
        find_ray_index
        IBXNE   to_lights, r0, r0, simple_dark
        STO     [to_nearest, loop_ray_index], segment_in
        .if     SIMPLE_YIELDS
        store_depth segment_out
        .else
        store_depth segment_in
        .endif
        STO     [to_nearest_primitive, loop_ray_index], its_primitive
        IBXEQ   its_patch, r0, r0, simple_skip
        LOD     [from_patch_s, loop_index], segment_in
        LOD     [from_patch_t, loop_index], segment_out
        STO     [to_hit_s, loop_ray_index], segment_in
        STO     [to_hit_t, loop_ray_index], segment_out
        BIM     simple_skip
simple_second:
        RTOR    segment_out, segment_in
        CFPLT   w_lower, segment_in, simple_ahead
        BIM     simple_skip
simple_tie:
        CFPNE   segment_in, ray_limit, simple_skip
        IBXNE   to_lights, r0, r0, simple_skip
        find_ray_index
        LOD     [to_nearest_primitive, loop_ray_index], loop_work
        IBXLT   its_primitive, r0, loop_work, simple_taken
        BIM     simple_skip
simple_dark:
        STO     [to_nearest, loop_ray_index], m_minus_big
simple_skip:
        loop_next simple_next
        to_vector
        region_took_hits
        BIM     walk_skip

walk_tree:
        walk_rays
        IBXNE   to_lights, r0, r0, tree_to_light
        LOD     [to_nearest, loop_ray_index], loop_work
        .if     KEYS
        load_tie w_out, next_in
        ADDN    w_in, next_in, next_in
        take_nearer next_in, tree_taken
        .else
        take_nearer w_in, tree_taken
        .endif
        STO     [to_nearest_primitive, loop_ray_index], w_out
        store_depth w_in
        find_point tree_skip
        STO     [to_hit_s, loop_ray_index], segment_in
        STO     [to_hit_t, loop_ray_index], segment_out
        rays_end
        .endkernel

        .kernel shadow
tree_to_light:
        IBXEQ   its_shadow, r0, m_index_one, tree_dark
        load_ray
        EX      from_red, light_left
        EX      from_green, light_left + 64 * QUEUE
        EX      from_blue, light_left + 64 * QUEUE * 2
        load_three from_red, from_green, from_blue, loop_ray_index, s_red, s_green, s_blue
tree_clear:
        pass_through tree_dark
        ADDN    w_in, w_lower, w_in
        next_visible w_in, tree_passed
        BIM     tree_clear
tree_passed:
        store_three from_red, from_green, from_blue, loop_ray_index, s_red, s_green, s_blue
        BIM     tree_skip
tree_dark:
        STO     [to_nearest, loop_ray_index], m_minus_big
        BIM     tree_skip
        .endkernel
