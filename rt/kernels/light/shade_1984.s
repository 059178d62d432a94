; shade_1984.s - computes the colours of a queue of rays, hit by hit.
;
; In, out: as for shade_vector.s; nearest_primitive holds records.  The light of
; all hits is computed source by source, so that the rays to a light form a
; queue, which the kernels intersect with the regions.

; Operands that are passed for all loops of a queue.
        .share  loop
        .regs   r156, of_nearest, of_primitive, of_hit_s, of_hit_t
        .regs   r160, of_ox, of_oy, of_oz, of_dx, of_dy, of_dz
        .regs   r166, of_red, of_green, of_blue, of_depth, of_nx, of_ny, of_nz
        .regs   r173, of_id, of_first, of_position, of_next
        .equ    SHADE_OPERANDS, 21

        .regs   r177, hit_at, back_red, back_green, back_blue
        .regs   r181, new_ox, new_oy, new_oz, new_dx, new_dy, new_dz
        .regs   r187, new_distance, new_primitive, new_index
        .regs   r190, lit_ndotl, lit_ddotl, lit_distance, lit_red, lit_green
        .regs   r195, lit_blue, lit_highlights, lit_count, lit_limit
        .endshare
        .share  loop
        .reg    of_order, r192          ; indices in the planes, or 0
        .reg    of_sky, r196            ; the stops of scene_sky, or 0
        .endshare
        .reg    lit_least, r31

        .data
shade_operands: .space SHADE_OPERANDS
shade_link:     .word 0
shade_n:        .word 0
shade_hits:     .word 0                 ; the number of hits
shade_light_at: .word 0                 ; record of the current light
shade_lights:   .word 0                 ; number of lights left
shade_light:    .space LIGHT_SIZE       ; the record, with the colour that
hit_list:       .word 0                 ; reaches a point
                .descriptor LIGHT_SIZE, shade_light
        .if     BEAMS
shadow_parallel: .word 0                ; 1: rays to the light go to no point
        .endif
        .if     AREAS
shade_shadows:  .word 0                 ; the light or point of the rays
        .endif
        .align 64
hits:           .space HIT_SIZE * QUEUE
lit_store:      .space 7 * QUEUE        ; rays to a light, and their limits
        .code

        .macro  begin_hits
        load_words shade_operands, SHADE_OPERANDS, of_nearest
        load_word shade_hits, loop_count
        EX      hit_at, hits
        ES      loop_index, 0
        .endm

        .macro  next_hit again
        IX      hit_at, 64 * HIT_SIZE
        loop_next \again
        .endm

        .macro  call_hit routine
        store_word hit_at, hit_list, arguments
        call_routine \routine, link
        .endm

; pixel_of: the pixel of a ray, by its index in the queue.
        .macro  load_order
        load_words queue_order, 1, of_order
        .endm

        .macro  pixel_of ray, pixel
        RTOR    \ray, \pixel
        IBXEQ   of_order, r0, r0, pixel\@
        LOD     [of_order, \ray], \pixel
pixel\@:
        .endm

        .if     AREAS
        .include "light/area_1984.s"
        .endif

        .kernel shade
shade:
        pass_operands nearest, 4, 0, shade_operands
        pass_operands aox, 6, 4, shade_operands
        pass_operands out_red, 8, 10, shade_operands
        .if     ORIGINS_DIFFER
        load_word scene_levels, s1
        ES      s2, 1
        IBXEQ   level, r0, s1, shade_first
        ES      s2, 0
shade_first:
        pass_operands s2, 1, 18, shade_operands
        .else
        pass_operands from_one_point, 1, 18, shade_operands
        .endif
        pass_operands position, 1, 19, shade_operands
        pass_operands next_level, 1, 20, shade_operands
        pass_operands link_queue, 1, 0, shade_link
        pass_operands n, 1, 0, shade_n
        to_scalar

; Computes for each ray the surface of its hit, or the background.
        load_words shade_operands, SHADE_OPERANDS, of_nearest
        load_words scene_background, 3, back_red
        load_words scene_sky + 64 * 4, 1, of_sky
        load_order
        RTOR    n, loop_count
        ES      loop_index, 0
        EX      hit_at, hits
        ES      lit_count, 0
shade_ray:
        LOD     [of_primitive, loop_index], new_primitive
        IBXEQ   new_primitive, r0, r0, shade_background
        load_three of_ox, of_oy, of_oz, loop_index, new_ox, new_oy, new_oz
        load_three of_dx, of_dy, of_dz, loop_index, new_dx, new_dy, new_dz
        LOD     [of_nearest, loop_index], new_distance
        RTOR    loop_index, new_index
        RTOR    hit_at, loop_at
        store_to new_ox, HIT_SAMPLE, loop_at
        find_patch new_primitive
        IBXEQ   its_patch, r0, r0, shade_surface
        LOD     [of_hit_s, loop_index], loop_work
        LOD     [of_hit_t, loop_index], loop_ray_index
        address_of new_primitive, P_PATCH_POINT, loop_at
        STO     [loop_at], loop_work
        STO     [loop_at, m_index_one], loop_ray_index
shade_surface:
        call_hit surface
        IX      lit_count, 1
        IX      hit_at, 64 * HIT_SIZE
shade_ray_next:
        loop_next shade_ray
        store_word lit_count, shade_hits
        IBXEQ   lit_count, r0, r0, shade_done
        call_routine spawn_hits, loop_link
        load_words scene_lights, 2, new_ox
        store_words new_ox, 2, shade_light_at
        IBXEQ   new_oy, r0, r0, shade_store

; Finds for each light the hits that face it.
shade_towards:
        load_words shade_light_at, 1, loop_at
        load_from loop_at, LIGHT_SIZE, new_ox
        store_words new_ox, LIGHT_SIZE, shade_light
        begin_hits
        ES      lit_count, 0
        load_word k_shadow, lit_least
shade_towards_hit:
        call_hit towards
        load_part hit_at, HIT_NDOTL, 3, lit_ndotl ; D . L, distance
        CFPGE   r0, lit_ndotl, shade_towards_next
        load_words shade_light + 64 * 3, 4, lit_red ; lit_red .. lit_highlights
        CFPEQ   lit_highlights, r0, shade_towards_next
        SUBN    lit_distance, lit_least, lit_limit
        store_lanes light_left, 0, lit_count, lit_red, lit_green, lit_blue
        .if     BUMPS
        load_part hit_at, HIT_SAMPLE + SAMPLE_POINT, 3, new_ox
        load_part hit_at, HIT_LIGHT, 3, new_dx
        .else
        load_part hit_at, HIT_SAMPLE + SAMPLE_POINT, 6, new_ox ; point, L
        .endif
        store_lanes lit_store, 0, lit_count, new_ox, new_oy, new_oz
        store_lanes lit_store, 3, lit_count, new_dx, new_dy, new_dz
        store_lane lit_store, 6, lit_count, lit_limit
        IX      lit_count, 1
shade_towards_next:
        next_hit shade_towards_hit
        RTOR    lit_count, n
        IBXEQ   lit_count, r0, r0, shade_shine
        .if     AREAS
        area_begin
shade_walk:
        .endif
        to_vector
        .endkernel

; Traces the rays to the light.
        .kernel shadow
        add_to_counter rays_shadow, n
        EX      s2, lit_store
        EX      s3, 64 * QUEUE
        three_planes s2, s3, aox, aoy, aoz
        ADDX    aoz, s3, adx
        ADDX    adx, s3, ady
        ADDX    ady, s3, adz
        ADDX    adz, s3, nearest
        ES      from_one_point, 0
        .if     BEAMS
        EX      s2, shade_light
        IX      s2, 64 * LIGHT_BEAM
        LOD     [s2], s2
        RTOR    r0, s1
        IBXEQ   s2, r0, r0, shadow_of_point
        IX      s2, 64 * BEAM_PARALLEL
        LOD     [s2], s1
shadow_of_point:
        store_word s1, shadow_parallel, s2
        .endif
        .if     AREAS
        load_word shade_shadows, shadows
        .else
        EX      shadows, shade_light
        .endif
        EX      s0, walk_regions
        BSAVE   link_queue, [s0]
        to_scalar
        .if     AREAS
        area_next shade_walk
        .endif
        .endkernel

; Adds the transmitted light to the hits.
        .kernel shade
shade_shine:
        begin_hits
        ES      lit_count, 0
shade_shine_hit:
        load_part hit_at, HIT_NDOTL, 1, lit_ndotl
        CFPGE   r0, lit_ndotl, shade_shine_next
        load_words shade_light + 64 * 6, 1, lit_highlights
        CFPEQ   lit_highlights, r0, shade_shines
        load_lane lit_store, 6, lit_count, lit_limit
        load_lanes light_left, 0, lit_count, lit_red, lit_green, lit_blue
        IX      lit_count, 1
        CFPEQ   lit_limit, m_minus_big, shade_shine_next
        CFPNE   lit_red, r0, shade_some
        CFPNE   lit_green, r0, shade_some
        CFPEQ   lit_blue, r0, shade_shine_next
shade_some:
        store_words lit_red, 3, shade_light + 64 * 3
shade_shines:
        call_hit shine
shade_shine_next:
        next_hit shade_shine_hit
        load_words shade_light_at, 2, new_ox       ; also the number of lights left
        IX      new_ox, 64 * LIGHT_SIZE
        IX      new_oy, -1
        store_words new_ox, 2, shade_light_at
        IBXNE   new_oy, r0, r0, shade_towards

; Stores the colours of the hits.
shade_store:
        begin_hits
        load_order
shade_store_hit:
        load_part hit_at, HIT_DISTANCE, 3, new_distance ; primitive, place
        load_part hit_at, HIT_SAMPLE, 6, new_ox ; colour, normal
        pixel_of new_index, loop_ray_index
        store_three of_red, of_green, of_blue, loop_ray_index, new_ox, new_oy, new_oz
        IBXEQ   of_first, r0, r0, shade_store_next
        IX      new_primitive, 64 * P_ID
        LOD     [new_primitive], loop_work
        STO     [of_depth, loop_ray_index], new_distance
        store_three of_nx, of_ny, of_nz, loop_ray_index, new_dx, new_dy, new_dz
        STO     [of_id, loop_ray_index], loop_work
shade_store_next:
        next_hit shade_store_hit
shade_done:
        to_vector
        load_word shade_n, n
        load_word shade_link, link_queue
        BIM     0, link_queue

shade_background:
        IBXEQ   of_sky, r0, r0, shade_no_sky
        load_three of_dx, of_dy, of_dz, loop_index, new_dx, new_dy, new_dz
        see_sky new_dx, back_red
shade_no_sky:
        pixel_of loop_index, loop_ray_index
        store_three of_red, of_green, of_blue, loop_ray_index, back_red, back_green, back_blue
        IBXEQ   of_first, r0, r0, shade_ray_next
        STO     [of_depth, loop_ray_index], m_zero
        store_three of_nx, of_ny, of_nz, loop_ray_index, m_zero, m_zero, m_zero
        STO     [of_id, loop_ray_index], m_zero
        BIM     shade_ray_next
        .endkernel
