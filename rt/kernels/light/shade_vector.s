; shade_vector.s - computes the colours of a queue of rays.
;
; The h rays that hit something are sorted by material, for all primitives in a
; list of those that may have been hit, which mark_tested makes.  The hits of
; one material are selected by a compare and a compress.  Points, directions,
; normals and so on are vectors of length h in which the parts of the materials
; are contiguous; a table has their starts.  Operations that are equal for all
; hits are done at once, the others part by part.  At a point X with the unit
; normal N turned towards the eye, ray direction D, pigment c:
;
;   colour = ambient c
;          + the light of each source (light_vector.s)
;
; In:  the queue's rays, nearest, nearest_primitive; the scene.
; Out: colours in out_red ..; for the first level the other planes of the frame;
;      the reflected and refracted rays in the next level's list.
; Source: POV-Ray's finish (phong and Blinn's halfway vector).

        .share  phase
        .reg    parts_left, r189
        .reg    link_shade, r190
        .endshare

        .share  scratch
        .regs   r233, f_ambientr, f_ambientg, f_ambientb, f_diffuse, f_phong
        .regs   r238, f_size, f_specular, f_sharpness
        .endshare

        .if     PATTERNS
        .share  scratch
        .regs   r240, map_function, map_wave, map_a, map_b, map_c, map_d
        .regs   r246, map_stops, map_stop_count
        .endshare
        .endif

        .if     BUMPS
        .share  scratch
        .reg    bump_at, r233
        .endshare
        .endif

        .include "light/hits_vector.s"

; Describes the indices of the hits in the planes, for queues ordered by tiles
; (order.s).
        .macro  order_hits into
        describe \into, order_hit_store, h
        .endm

; Loop over the parts of the hits.
        .macro  parts_begin
        EX      part_at, hit_parts
        load_word hit_part_count, parts_left
        .endm

        .macro  part_begin
        call_routine set_part, link_inner
        .endm

        .macro  parts_next again
        IX      part_at, 64 * PART_SIZE
        IBXNE   parts_left, minus_one_index, r0, \again, parts_left
        .endm

; Branches to other if the rays are not camera rays.  Without ORIGINS_DIFFER
; these are the only ones that start at one point.
        .macro  unless_first_level other
        .if     ORIGINS_DIFFER
        load_word scene_levels, s0
        IBXNE   level, r0, s0, \other
        .else
        IBXEQ   from_one_point, r0, r0, \other
        .endif
        .endm

        .kernel shade
shade:
        RTOR    link, link_shade
        load_word queue_order, s0
        IBXNE   s0, r0, r0, shade_sky
        load_words scene_background, 3, s1, shape_at
        copy_three s1, s2, s3, [out_red], [out_green], [out_blue], VTOV
        unless_first_level shade_sky
        describe near_bits, queue_bits, n
        VTOV    r0, [out_depth]
        CMPNEV  [nearest_primitive], r0, [near_bits]
        VTOV    [nearest], [out_depth] ? [near_bits]
        VTOV    r0, [out_nx]
        VTOV    r0, [out_ny]
        VTOV    r0, [out_nz]
        VTOV    [nearest_primitive], [out_id]

; Computes the colour of the sky for the rays that hit nothing.
shade_sky:
        load_word scene_sky + 64 * 4, s0
        IBXEQ   s0, r0, r0, shade_sort
        describe near_bits, queue_bits, n
        CMPEQV  [nearest_primitive], r0, [near_bits]
        if_none near_bits, h, shade_sort
        call_routine set_hits, link_inner
        describe s4, count_store, n
        CPSV    [s4], [at] ? [near_bits]
        CPSV    [adx], [px] ? [near_bits]
        CPSV    [ady], [py] ? [near_bits]
        CPSV    [adz], [pz] ? [near_bits]
        load_words scene_sky, 6, m00, shape_at
        EX      target, find_gradient
        .if     PATTERNS
        load_word sky_map, s0
        IBXEQ   s0, r0, r0, shade_sky_colours
        load_words sky_pattern, 12, m00, shape_at
        load_words sky_map, MAP_SIZE, map_function, shape_at
        EX      target, find_pattern
shade_sky_colours:
        .endif
        BSAVE   link_inner, [target]
        load_word queue_order, s2
        IBXEQ   s2, r0, r0, shade_sky_store
        VXTOV   [at], [s2], [v0]
        RTOR    v0, at
shade_sky_store:
        three_by VTOVX, [at], [cr], [cg], [cb], [out_red], [out_green], [out_blue]

shade_sort:
        ES      h, 0
        ES      parts_left, 0
        load_word first_material, primitive
        IBXEQ   primitive, r0, one_index, shade_done
        store_word one_index, first_material, shape_at
        EX      at, shade_store
        EX      part_at, hit_parts
        RTOR    n, s8
        describe s4, count_store, n
        RTOR    nearest_primitive, s5
        load_word scene_shared_materials, s6
        IBXEQ   s6, r0, r0, sort_next
        describe near_bits, queue_bits, n
        CMPNEV  [nearest_primitive], r0, [near_bits]
        CNTOB   [near_bits], s8
        EX      s4, found_store
        EX      s5, found_store + 64 * QUEUE
        CPSV    [iota], [s4] ? [near_bits]
        CPSV    [nearest_primitive], [s5] ? [near_bits]
        find_records s5, s5, P_MATERIAL, s1
        VXTOV   [s5], [s1], [s5]

; s8 rays are not yet sorted: s4 = their indices, s5 = the materials or
; primitives they hit.
sort_next:
        load_record P_TESTED, 2, s2
        RTOR    s2, s9
        store_field P_TESTED, r0
        store_field P_SHARED, r0
        RTOR    primitive, identity
        IBXNE   s6, r0, r0, sort_find
        load_field P_ID, identity
sort_find:
        describe near_bits, queue_bits, s8
        CMPEQV  [s5], identity, [near_bits]
        if_none near_bits, m, sort_none
        RTOR    at, s1
        CPSV    [s4], [s1] ? [near_bits]
        STO     [part_at], primitive
        IX      part_at, 64
        STO     [part_at], h
        IX      part_at, 64
        STO     [part_at], m
        IX      part_at, 64
        STO     [part_at], s3
        IX      part_at, 64
        IX      parts_left, 1
        ADDX    h, m, h
        advance_by at, m, s0
        IBXEQ   s9, r0, one_index, sort_none
        SHIFTI  m, 3, s0                        ; an eighth: they are removed
        IBXLT   s0, r0, s8, sort_none
        SUBX    s8, m, s8
        IBXEQ   s8, r0, r0, sort_rest
        NANDB   [near_bits], [near_bits], [near_bits]
        RTOR    s4, s0
        RTOR    s5, s1
        EX      s4, found_store
        EX      s5, found_store + 64 * QUEUE
        CPSV    [s0], [s4] ? [near_bits]
        CPSV    [s1], [s5] ? [near_bits]
sort_none:
        RTOR    s9, primitive
        IBXNE   primitive, r0, one_index, sort_next
        BIM     sort_done

; No ray is left: clears the marks of the remaining primitives.
sort_rest:
        RTOR    s9, primitive
        IBXEQ   primitive, r0, one_index, sort_done
        load_field P_TESTED, s9
        store_field P_TESTED, r0
        store_field P_SHARED, r0
        BIM     sort_rest
sort_done:
        IBXEQ   h, r0, r0, shade_done
        store_word parts_left, hit_part_count, shape_at
        call_routine set_hits, link_inner
        VXTOV   [at], [nearest], [v0]
        load_word queue_order, s2
        IBXEQ   s2, r0, r0, shade_points
        order_hits s3
        VXTOV   [at], [s2], [s3]
        VTOVX   [s3], [v0], [out_depth]
        VXTOV   [at], [nearest_primitive], [v1]
        VTOVX   [s3], [v1], [out_id]
shade_points:
        IBXNE   from_one_point, r0, r0, shade_view
        point   aox, adx, px, hdx
        point   aoy, ady, py, hdy
        point   aoz, adz, pz, hdz
        BIM     shade_surfaces
shade_view:
        point_of_view aox, adx, px, hdx
        point_of_view aoy, ady, py, hdy
        point_of_view aoz, adz, pz, hdz

; Computes for each part the normals, spawned rays, pigments and ambient light.
shade_surfaces:
        parts_begin
shade_surface:
        part_begin
        call_routine find_normal, link_kernel
        .if     GLOSS
        call_routine find_pigment, link_kernel
        call_routine spawn, link_kernel
        .else
        call_routine spawn, link_kernel
        call_routine find_pigment, link_kernel
        .endif
        load_record P_FINISH, 3, f_ambientr
        MPYSV   [cr], f_ambientr, [red]
        MPYSV   [cg], f_ambientg, [green]
        MPYSV   [cb], f_ambientb, [blue]
        parts_next shade_surface

; Adds the light of each source.
        load_word scene_lights, light_at
        load_word scene_light_count, lights_left
        IBXEQ   lights_left, r0, r0, shade_store_colours
shade_light:
        call_routine illuminate, link
        IX      light_at, 64 * LIGHT_SIZE
        IBXNE   lights_left, minus_one_index, r0, shade_light, lights_left

shade_store_colours:
        call_routine set_hits, link_inner
        load_word queue_order, s2
        RTOR    at, s3
        IBXEQ   s2, r0, r0, shade_store_at
        order_hits s3
shade_store_at:
        three_by VTOVX, [s3], [red], [green], [blue], [out_red], [out_green], [out_blue]
        unless_first_level shade_done
        three_by VTOVX, [s3], [nx], [ny], [nz], [out_nx], [out_ny], [out_nz]
shade_done:
        BIM     0, link_shade
        .endkernel

        .include "light/surface_vector.s"
