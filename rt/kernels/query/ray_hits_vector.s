; ray_hits_vector.s - scatters the visible crossings of a queue to their planes.
;
; The next crossing of a ray with k crossings goes to column k, so no ray
; occurs twice in one scatter.
;
; found_crossings: In: the crossings of the rays of [visible_rays] at [event],
;                  on event_primitive; the values of the region's tree after them.
;                  Out: [visible_rays] is empty, so all rays continue.
; Source: derived here.

        .regs   r208, query_link, query_taken, query_index, query_to, query_normals

        .data
query_saved:    .space 21               ; event .. slot_size
query_part:     .space PART_SIZE        ; of one primitive
        .align  64
query_store:    .space 2 * QUEUE
        .code

; Stores [vector] in the next plane, for the rays of query_index.
        .macro  to_plane vector
        VTOVX   [query_index], \vector, [s4]
        ADDX    s4, query_stride, s4
        .endm

        .macro  to_plane_of_hits vector
        VXTOV   [taken_at], [\vector], [taken_distance]
        to_plane [taken_distance]
        VTOVX   [taken_at], r0, [\vector]       ; 0 for other primitives
        .endm

        .kernel lines
found_crossings:
        RTOR    link_kernel, query_link
        RTOR    visible_rays, s5
        call_routine found_points, link_kernel
        take_found ray_index, taken_at, 0, visible_rays
        take_found event, taken_distance, 1, visible_rays
        take_found event_primitive, taken_primitive, 2, visible_rays
        LTOR    taken_at, query_taken
        describe query_index, query_store, query_taken
        describe s3, query_store + 64 * QUEUE, query_taken
        VXTOV   [taken_at], [query_counts_at], [query_index]
        ADDXV   one_index, [query_index], [s3]
        VTOVX   [taken_at], [s3], [query_counts_at]
        SHIFTI  query_step, -6, s2
        MPYLV   [query_index], s2, [query_index]
        ADDXV   [query_index], [taken_at], [query_index]
        .if     NORMALS
        call_routine find_normals, link_kernel
        .endif
        CFPEQ   query_start_distance, r0, found_from_origin
        SUBNV   [taken_distance], query_start_distance, [taken_distance]
found_from_origin:
        RTOR    ray_hits_first, s4
        to_plane [taken_distance]
        to_plane [taken_primitive]

; The directions of crossing follow from the values after the crossings.
        load_of region, R_BODY, s6
        SUBX    r0, s6, s7
        tree_value
        describe s3, query_store + 64 * QUEUE, near
        VTOV    s7, [s3]
        VTOV    s6, [s3] ? [value_after]
        take_found s3, taken_distance, 1, visible_rays
        to_plane [taken_distance]
        to_plane_of_hits hit_s
        to_plane_of_hits hit_t
        VTOV    [after], [event] ? [visible_rays] ; within delta: the same place
        XORB    [visible_rays], [visible_rays], [visible_rays]
        BIM     0, query_link

        .if     NORMALS
; Computes the normals at these crossings, one primitive after another, and
; stores them in their planes. Scratch registers of other routines are
; preserved.
find_normals:
        RTOR    link_kernel, query_normals
        store_words event, 21, query_saved, shape_at
        EX      part_at, query_part
        leaves_begin
normals_leaf:
        load_leaf_record
        load_field P_ID, identity
        describe near_bits, queue_bits, query_taken
        CMPEQV  [taken_primitive], identity, [near_bits]
        if_none near_bits, h, normals_next
        call_routine set_hits, link_inner
        RTOR    h, m
        EX      query_to, query_store + 64 * QUEUE
        CPSV    [taken_at], [at] ? [near_bits]
        CPSV    [taken_distance], [v0] ? [near_bits]
        CPSV    [query_index], [query_to] ? [near_bits]
        point   aox, adx, px, hdx
        point   aoy, ady, py, hdy
        point   aoz, adz, pz, hdz
        call_routine find_normal, link_kernel
        ES      s4, RAY_HIT_NORMAL
        MPYX    query_stride, s4, s4
        ADDX    ray_hits_first, s4, s4
        VTOVX   [query_to], [nx], [s4]
        ADDX    s4, query_stride, s4
        VTOVX   [query_to], [ny], [s4]
        ADDX    s4, query_stride, s4
        VTOVX   [query_to], [nz], [s4]
normals_next:
        leaves_next normals_leaf
        load_words query_saved, 21, event, shape_at
        BIM     0, query_normals
        .endif
        .endkernel
