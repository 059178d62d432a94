; area_1984.s - computes the light of an area light that reaches the hits of a
; queue, ray by ray.  The order of the operations is that of area_vector.s.
; These macros are a part of shade_1984.s; the queue of rays to a point of the
; area is made in lit_store.

        .share  loop
        .regs   r177, area_x, area_y, area_z, area_weight
        .regs   r181, area_dx, area_dy, area_dz, area_distance
        .regs   r185, area_work, area_r, area_g, area_b, area_sum, area_next_at
        .regs   r191, area_next_left
        .endshare

        .data
area_at:        .word 0                 ; the point; the number of points left
                .word 0
area_rays:      .word 0                 ; of the queue
        .align  64
area_store:     .space 3 * QUEUE        ; sum of the transmitted light
        .code

        .macro  area_loop
        load_words area_rays, 1, loop_count
        ES      loop_index, 0
        .endm

; Stores the next point of the area and the number of points left.
        .macro  area_continue
        store_words area_next_at, 2, area_at
        .endm

; Replaces the rays to the light by rays to the point in area_at.
        .macro  area_rays_to_point
        load_words area_at, 1, area_next_at
        store_word area_next_at, shade_shadows
        load_from area_next_at, LIGHT_POINT_SIZE, area_x
        load_words shade_light + 64 * LIGHT_COLOR, 3, area_r
        area_loop
area_ray\@:
        load_lanes lit_store, 0, loop_index, area_dx, area_dy, area_dz
        SUBN    area_x, area_dx, area_dx
        SUBN    area_y, area_dy, area_dy
        SUBN    area_z, area_dz, area_dz
        direction_by m_one, area_dx, area_dy, area_dz, area_distance, area_work
        store_lanes lit_store, 3, loop_index, area_dx, area_dy, area_dz
        store_lane lit_store, 6, loop_index, area_distance
        store_lanes light_left, 0, loop_index, area_r, area_g, area_b
        loop_next area_ray\@
        load_words area_rays, 1, loop_at
        RTOR    loop_at, n
        .endm

        .macro  area_add number
        load_lane light_left, \number, loop_index, area_r
        load_lane area_store, \number, loop_index, area_sum
        MPYS    area_weight, area_r, area_r
        ADDN    area_sum, area_r, area_sum
        store_lane area_store, \number, loop_index, area_sum
        .endm

        .macro  area_end number
        load_lane area_store, \number, loop_index, area_sum
        store_lane light_left, \number, loop_index, area_sum
        .endm

; If shade_light has an area, makes the rays to its first point.
        .macro  area_begin
        EX      loop_at, shade_light
        store_word loop_at, shade_shadows
        load_words shade_light + 64 * LIGHT_BEAM, 1, loop_at
        ES      area_next_at, 0
        IBXEQ   loop_at, r0, r0, area_begin\@
        IX      loop_at, 64 * BEAM_POINTS
        load_from loop_at, 2, area_next_at
area_begin\@:
        area_continue
        IBXEQ   area_next_at, r0, r0, area_begun\@
        store_word lit_count, area_rays
        area_loop
area_zero\@:
        store_lanes area_store, 0, loop_index, m_zero, m_zero, m_zero
        loop_next area_zero\@
        area_rays_to_point
area_begun\@:
        .endm

; Adds the light from a point of the area and continues at walk with the next
; point.
        .macro  area_next walk
        load_words area_at, 1, area_next_at
        IBXEQ   area_next_at, r0, r0, area_done\@
        IX      area_next_at, 64 * LIGHT_POINT_WEIGHT
        LOD     [area_next_at], area_weight
        area_loop
area_ray\@:
        load_lane lit_store, 6, loop_index, area_distance
        CFPEQ   area_distance, m_minus_big, area_dark\@
        area_add 0
        area_add 1
        area_add 2
area_dark\@:
        loop_next area_ray\@
        load_words area_at, 2, area_next_at
        IX      area_next_at, 64 * LIGHT_POINT_SIZE
        IX      area_next_left, -1
        area_continue
        IBXEQ   area_next_left, r0, r0, area_last\@
        area_rays_to_point
        BIM     \walk
area_last\@:
        area_loop
area_sum\@:
        store_lane lit_store, 6, loop_index, m_zero
        area_end 0
        area_end 1
        area_end 2
        loop_next area_sum\@
area_done\@:
        .endm
