; forms_vector.s - kernels of light that are written once, in the vector form:
; their registers, which have the names of the scalar form, and the macros that
; differ from those of forms_scalar.s.

        .share  light
        .reg    here, s0
        .reg    m_index_minus_one, minus_one_index
        .endshare

; [c] = [a] in hits3, else 1.
        .macro  copy_lit a, c
        MASKV   [\a], one, [\c] ? [hits3]
        .endm

; power.s, for m numbers
        .share  light
        .regs   v0, p_x, p_k, p_s, p_square
        .reg    power_link, link_inner
        .reg    exp_one, one
        .endshare

; [v0] := [v0] ^ exponent where [v0] is above 0, else 0.  Also changes hits0,
; s2.
        .macro  power_of_positive
        CMPLTV  r0, [v0], [hits0]
        MASKV   [v0], one, [v0] ? [hits0]
        call_routine power, power_link
        ADDN    r0, r0, s2
        MASKV   [v0], s2, [v0] ? [hits0]
        .endm

; fog.s
        .share  scratch
        .regs   r233, fog_at, fogs_left
        .regs   r235, fog_scale, fog_least, fog_red, fog_green, fog_blue
        .regs   r240, fog_pass_red, fog_pass_green, fog_pass_blue
        .endshare
        .share  light
        .regs   v5, fog_share, fog_work
        .regs   red, pass_red, pass_green, pass_blue
        .regs   cr, haze_red, haze_green, haze_blue
        .endshare

; gloss.s
        .share  scratch
        .regs   r248, f_brilliance, f_metallic
        .reg    link_gloss, r250
        .endshare
        .share  light
        .regs   v0, g_sheen, g_root, g_cosine, g_signed
        .reg    g_metal, v7
        .reg    g_at, s0
        .regs   m00, g_a7, g_a6, g_a5, g_a4, g_a3, g_a2, g_a1, g_a0
        .regs   m20, g_turn, g_scale, g_top
        .endshare

        .macro  find_sheen
        call_routine find_sheen, link_inner
        .endm

; mirror.s
        .share  light
        .regs   sh0, g_red, g_green, g_blue, g_falloff, g_metallic, g_kind
        .regs   cr, g_pigment_r, g_pigment_g, g_pigment_b
        .regs   v1, g_g, g_less, g_more, g_p
        .regs   v5, g_seen, g_share
        .reg    g_index, g_less
        .reg    g_work, v1
        .reg    sp_facing, facing
        .regs   red, sp_red, sp_green, sp_blue
        .endshare

        .macro  set_mirror_weight
        VTOV    spawn_most, [ndotl]
        .endm
        .macro  weigh_mirror
        .endm
        .macro  add_share_of_range
        line    g_share, g_red, spawn_r, red
        line    g_share, g_green, spawn_g, green
        line    g_share, g_blue, spawn_b, blue
        .endm
        .macro  find_mirror_index to
        .if     INTERIORS
        VTOV    [v7], [\to]
        .else
        find_entering
        MASKV   spawn_index, spawn_reciprocal, [\to] ? [hits2]
        .endif
        .endm
        .macro  load_pigment
        .endm

; light.s
        .share  light
        .reg    light_distance, v0
        .reg    ddotl, v6
        .endshare

        .macro  beam_towards
        call_routine beam_towards, link_inner
        .endm
        .macro  add_where bits, x, channel
        ADDNV   [\channel], [\x], [\channel] ? [\bits]
        .endm

; hits3 = the points that face the light.
        .macro  leave_if_dark label
        CMPLTV  r0, [ndotl], [hits3]
        if_none hits3, s0, \label
        .endm
        .macro  leave_if_matt label
        ADDN    f_phong, f_specular, s0
        CFPGE   r0, s0, \label
        .endm

; hits0 = the points with a highlight, where [x] is above 0; 1 elsewhere.
        .macro  base_of_highlight x, none
        CMPLTV  r0, [\x], [hits0]
        ANDB    [hits0], [hits3], [hits0]
        if_none hits0, s0, \none
        MASKV   [\x], one, [\x] ? [hits0]
        .endm
        .macro  leave_if_indefinite x, label
        .endm
        .macro  root_lit x
        SQRTV   [\x], [\x] ? [hits3]
        MASKV   [\x], one, [\x] ? [hits3]
        .endm

; beam.s
        .share  shape
        .regs   r40, beam_attenuates, beam_parallel, beam_kind
        .regs   r43, beam_x, beam_y, beam_z, beam_narrow, beam_low, beam_steep
        .regs   r49, beam_tightness, beam_fade, beam_power
        .endshare
        .share  light
        .reg    attenuation, v7
        .reg    beam_off, v5
        .reg    beam_q, v0
        .reg    beam_three, s0
        .endshare

        .macro  leave_beam label
        BIM     0, link_inner
        .endm
        .macro  darken_far_side none
        CMPLTV  r0, [light_distance], [hits1]
        VTOV    r0, [beam_q] ?! [hits1]
        .endm
        .macro  darken_unless_above_0 x, none
        CMPLTV  r0, [\x], [hits1]
        ANDB    [hits1], [hits3], [hits3]
        .endm
        .macro  smaller_to_greater
        CMPLTV  one, [beam_q], [hits2]          ; farther than fade_distance
        DIVSV   one, [beam_q], [v1]
        VTOV    [v1], [beam_q] ? [hits2]
        copy_lit beam_q, p_x
        .endm
        .macro  one_where_near x
        MASKV   [\x], one, [\x] ? [hits2]
        .endm

; image.s: v5 v6 v7 = x, y, z; map_function .. = P_MAP; link_pattern.  Results
; in cr cg cb.  Changes v0-v7, red, green, blue, hits1-hits3, s0-s9.
        .share
        .regs   r7, row_words, pixel_words, edge_before, edge_after, last_column
        .endshare
        .share  light
        .regs   v0, y_0, y_1, y_2, y_3, y_4, q_x, q_y, q_z
        .regs   v0, column_at, row_at, row_before, column_before, texel
        .reg    image_work, texel
        .regs   cr, image_r, image_g, image_b, image_pixel, image_none, weight_sum
        .reg    image_u, image_r
        .reg    weight, v7
        .reg    inner_link, link_inner
        .reg    colour_link, link_inner
        .endshare

; find_cells: In: px py pz; the primitive's record.  Out: hits3 = the points in
; the second cell of its pigment, a checker or a bounded image.  Changes v0-v4,
; hits1.
        .macro  begin_image
find_cells:
        load_field P_PIGMENT, s0
        IBXEQ   s0, r0, one_index, find_checker
        load_record P_PATTERN, 8, m00
        local_coordinate m00, m01, m02, m03, v1
        local_coordinate m10, m11, m12, m13, v2
        find_tile v1, v2, v3, v4
        load_field P_MAP_NUMBERS + 2, s0
        find_outside s0, v3, v4, cells_found
cells_found:
        BIM     0, link_inner
        .endm

; hits3 = the points outside of the image, by bound, which is not 0.
        .macro  find_outside bound, u_floor, v_floor, within
        CMPNEV  [\v_floor], minus_one, [hits3]
        CFPNE   \bound, two, \within
        CMPNEV  [\u_floor], r0, [hits1]
        ORB     [hits1], [hits3], [hits3]
        .endm
        .macro  find_colour
        RTOR    map_wave, target
        BSAVE   link_inner, [target]
        CFPEQ   map_c, r0, image_found
        load_record P_COLOR + 3, 3, s1
        VTOV    s1, [cr] ? [hits3]
        VTOV    s2, [cg] ? [hits3]
        VTOV    s3, [cb] ? [hits3]
image_found:
        BIM     0, link_pattern
        .endm
        .macro  load_pixel
        RTOR    map_stops, s0
        VXTOV   [texel], [s0], [cr]
        IX      s0, 64
        VXTOV   [texel], [s0], [cg]
        IX      s0, 64
        VXTOV   [texel], [s0], [cb]
        .endm
        .macro  add_channel color
        VXTOV   [texel], [s0], [image_pixel]
        MPYSV   [image_pixel], [weight], [image_pixel]
        ADDNV   [\color], [image_pixel], [\color]
        IX      s0, 64
        .endm
        .macro  add_pixel
        RTOR    map_stops, s0
        add_channel cr
        add_channel cg
        add_channel cb
        .endm

; bump.s: changes v0-v7, hits1-hits3, lx .., cr .., red .., ndotl; keeps hits0.
        .share  scratch
        .regs   r234, bump_outer, bump_left, bump_corner, bump_corners_left
        .regs   r250, link_bump, height_link
        .endshare
        .share  light
        .reg    bump_link, link_kernel
        .regs   m00, b0, b1, b2, b3, b4, b5, b6, b7, b8, b9, b10, b11
        .regs   nx, raw_x, raw_y, raw_z
        .regs   red, bump_x, bump_y, bump_z
        .regs   cr, bump_sum_x, bump_sum_y, bump_sum_z
        .reg    bump_value, facing
        .reg    bump_weight, s1
        .reg    bump_flag, s1
        .regs   m00, bump_from, bump_to, bump_low, bump_rise
        .reg    height_at, s9
        .regs   sh0, height_from, height_slope, height_0, height_1, height_2, height_3
        .endshare

; Describes the normals of the part without bumps.
        .macro  normals_before x0, x1, x2
        describe \x0, bump_normals, m
        describe \x1, bump_normals + 64 * QUEUE, m
        describe \x2, bump_normals + 64 * QUEUE * 2, m
        .endm
        .macro  begin_bumps
bumped:
        RTOR    link_inner, link_bump
        normals_before s1, s2, s3
        copy_three [nx], [ny], [nz], [s1], [s2], [s3], VTOV
        apply_bumps
        .endm
        .macro  leave_bumped label
        BIM     0, link_bump
        .endm

; bump_upper adds the share ndotl of [x] to [sum] in hits1; bump_lower sets
; [sum] to the share v0 of [x] in hits2.
        .macro  bump_upper x, sum
        MPYSV   [\x], [ndotl], [v1]
        ADDNV   [\sum], [v1], [\sum] ? [hits1]
        .endm
        .macro  bump_lower x, sum
        MPYSV   [\x], [v0], [v1]
        VTOV    [v1], [\sum] ? [hits2]
        .endm

; bump_sum_x .. = the normals between the entries below and above bump_value.
; Entry by entry: ndotl = the share of the upper entry.
        .macro  sum_of_two_entries
bumped_entry:
        call_bump
        load_part bump_at, BUMP_FROM, 4, bump_from, shape_at
        CFPGE   bump_from, big, bumped_lower    ; the first entry
        CMPGEV  [bump_value], bump_from, [hits1]
        keep_where CMPLTV, [bump_value], bump_to, hits1, hits2
        bump_upper lx, bump_sum_x
        bump_upper ly, bump_sum_y
        bump_upper lz, bump_sum_z
        CFPGE   bump_to, big, bumped_next       ; the last entry
bumped_lower:
        CMPGEV  [bump_value], bump_to, [hits2]
        lowered_scale bump_value, bump_low, bump_rise, v0
        not_below_number m_zero, v0
        not_above_number m_one, v0
        VTOV    [v0], [ndotl]
        SUBNV   one, [v0], [v0]
        bump_lower lx, bump_sum_x
        bump_lower ly, bump_sum_y
        bump_lower lz, bump_sum_z
bumped_next:
        IX      bump_at, 64 * BUMP_SIZE
        IBXNE   bump_left, minus_one_index, r0, bumped_entry, bump_left
        .endm

; Loads each height of the map; hits1 = the values that are not below it.
        .macro  each_height next, last
        load_from height_at, HEIGHT_SIZE, height_from
        VTOV    height_0, [v3]
\next:
        IX      height_at, 64 * HEIGHT_SIZE
        load_from height_at, HEIGHT_SIZE, height_from
        CFPGE   height_from, big, \last
        CMPGEV  [y_0], height_from, [hits1]
        .endm
        .macro  set_height next, last
        ADDNV   [v2], height_0, [v3] ? [hits1]
        BIM     \next
\last:
        VTOV    [v3], [y_0]
        .endm
