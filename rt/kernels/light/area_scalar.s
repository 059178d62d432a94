; area_scalar.s - computes the light of an area light that reaches a point.  The
; order of the operations is that of area_vector.s.  These macros are a part of
; shade_scalar.s.

        .share  local
        .regs   r58, area_x, area_y, area_z, area_weight, area_at, area_left
        .regs   r64, area_r, area_g, area_b, area_distance
        .regs   r68, area_transmitted_r, area_transmitted_g, area_transmitted_b
        .endshare

; area_at, area_left = address and number of the points of light_beam.  Branches
; to none if it has no area.
        .macro  area_of_light none
        IBXEQ   light_beam, r0, r0, \none
        load_part light_beam, BEAM_POINTS, 2, area_at
        IBXEQ   area_at, r0, r0, \none
        .endm

        .macro  area_add sum, transmitted
        MPYS    area_weight, \transmitted, t0
        ADDN    \sum, t0, \sum
        .endm

; light_r, light_g, light_b = the light from all points of the area.
        .macro  light_of_area
        RTOR    m_zero, area_r
        RTOR    m_zero, area_g
        RTOR    m_zero, area_b
area_point\@:
        load_from area_at, LIGHT_POINT_SIZE, area_x
        three   SUBN, area_x, area_y, area_z, px, py, pz, area_x, area_y, area_z
        direction_by m_one, area_x, area_y, area_z, area_distance, t1
        EX      here, shadow_ray + 64 * 3
        store_to area_x, 3, here
        cast_shadow area_distance, area_at
        load_from here, 3, area_transmitted_r
        area_add area_r, area_transmitted_r
        area_add area_g, area_transmitted_g
        area_add area_b, area_transmitted_b
        IX      area_at, 64 * LIGHT_POINT_SIZE
        IBXNE   area_left, m_index_minus_one, r0, area_point\@, area_left
        copy_three area_r, area_g, area_b, light_r, light_g, light_b
        .endm
