; forms_scalar.s - kernels of light that are written once, in the scalar form:
; their registers, and the macros that differ from those of forms_vector.s.

; c = a, where the light reaches the surface, else 1.
        .macro  copy_lit a, c
        RTOR    \a, \c
        .endm

; power.s
        .regs   r233, p_x, p_k, p_s, p_square, power_link
        .reg    exp_one, m_one

; p_x := p_x ^ exponent if p_x is above 0, else 0.
        .macro  power_of_positive
        CFPGE   r0, p_x, power_dark\@
        call_routine power, power_link
        BIM     power_done\@
power_dark\@:
        RTOR    m_zero, p_x
power_done\@:
        .endm

; fog.s
        .share  local
        .regs   r32, fog_at, fogs_left, fog_distance
        .regs   r35, fog_scale, fog_least, fog_red, fog_green, fog_blue
        .regs   r40, fog_pass_red, fog_pass_green, fog_pass_blue
        .regs   r43, fog_share, fog_work
        .regs   r45, pass_red, pass_green, pass_blue, haze_red, haze_green
        .reg    haze_blue, r50
        .endshare

; gloss.s
        .share  local
        .regs   r95, f_brilliance, f_metallic
        .regs   r97, g_sheen, g_cosine, g_work, g_root
        .regs   r101, g_a7, g_a6, g_a5, g_a4, g_a3, g_a2, g_a1, g_a0
        .regs   r109, g_turn, g_scale, g_top
        .endshare
        .reg    g_signed, third
        .reg    g_metal, g_sheen
        .reg    g_at, g_work
        .equ    GLOSS_REGISTERS, 80     ; up to these

        .macro  find_sheen
        compute_sheen
        .endm

; mirror.s
        .share  local
        .regs   r112, g_red, g_green, g_blue, g_falloff, g_metallic, g_kind
        .regs   r118, g_pigment, g_pigment_r, g_pigment_g, g_pigment_b
        .regs   r122, g_g, g_less, g_more, g_p
        .endshare
        .reg    g_share, g_sheen
        .reg    g_index, g_work
        .equ    MIRROR_REGISTERS, 94    ; up to these

        .macro  set_mirror_weight
        .endm
        .macro  weigh_mirror
        MPYS    sp_own_weight, sp_greatest, sp_weight
        .endm
        .macro  add_share_of_range
        scaled_plus g_share, g_red, sp_red, sp_red
        scaled_plus g_share, g_green, sp_green, sp_green
        scaled_plus g_share, g_blue, sp_blue, sp_blue
        .endm
        .macro  find_mirror_index to
        .if     INTERIORS
        RTOR    in_mirror, \to
        .else
        RTOR    sp_index, \to
        ES      sp_flag, 0
        CFPGE   sp_outward, r0, mirror_side
        ES      sp_flag, 1
mirror_side:
        IBXNE   sp_flag, r0, sp_inverted, mirror_enters
        RTOR    sp_reciprocal, \to
mirror_enters:
        .endif
        .endm
        .macro  load_pigment
        load_from g_pigment, 3, g_pigment_r
        .endm

; light.s
        .macro  beam_towards
        find_beam_direction
        .endm
        .macro  add_where bits, x, channel
        ADDN    \channel, \x, \channel
        .endm
        .macro  leave_if_dark label
        .endm
        .macro  leave_if_matt label
        .endm
        .macro  base_of_highlight x, none
        CFPGE   r0, \x, \none
        .endm
        .macro  leave_if_indefinite x, label
        CFPNE   \x, \x, \label
        .endm
        .macro  root_lit x
        SQRT    \x, \x
        .endm

; Computes L and N . L.  Branches to none if the light does not face the
; surface.
        .macro  towards_light none
        find_light_direction
        CFPGE   r0, ndotl, \none
        CFPNE   ndotl, ndotl, \none     ; indefinite: L = 0
        .if     BEAMS
        IBXEQ   light_beam, r0, r0, towards_lit\@
        compute_attenuation \none
towards_lit\@:
        .endif
        .endm

; beam.s
        .share  local
        .regs   r112, beam_attenuates, beam_parallel, beam_kind
        .regs   r115, beam_x, beam_y, beam_z, beam_narrow, beam_low, beam_steep
        .regs   r121, beam_tightness, beam_fade, beam_power
        .regs   r124, attenuation, beam_off, beam_q, beam_three
        .endshare

        .macro  leave_beam label
        BIM     \label
        .endm
        .macro  darken_far_side none
        CFPGE   r0, light_distance, \none
        .endm
        .macro  darken_unless_above_0 x, none
        CFPGE   r0, \x, \none
        .endm
        .macro  smaller_to_greater
        RTOR    beam_q, p_x
        CFPGE   m_one, beam_q, smaller\@
        DIVS    m_one, beam_q, p_x
smaller\@:
        .endm
        .macro  one_where_near x
        CFPLT   m_one, beam_q, one_where_near\@
        RTOR    m_one, \x
one_where_near\@:
        .endm

; Multiplies the light's colour, or its transmitted part, by the attenuation.
        .macro  attenuate_light
        three_by MPYS, attenuation, light_r, light_g, light_b, light_r, light_g, light_b
        .endm

; image.s: find_value calls its routines.  They return the colour in image_r ..,
; and image_cell for pigment_cell; if that is not 0 there is no colour.
        .share  local
        .regs   r48, row_words, pixel_words, column_at, column_before
        .regs   r52, row_at, row_before, image_u, texel, weight
        .regs   r58, corner_r, corner_g, corner_b, edge_before, edge_after
        .regs   r63, weight_sum
        .endshare

; Computes the cell of the primitive's image, for pigment_cell, which calls it
; by BSAVE image_link.
        .macro  begin_image
find_image_cell:
        load_record P_PATTERN, 12, sh0
        load_record P_MAP, MAP_SIZE, map_function
        pattern_colour
        RTOR    image_cell, cell
        BIM     0, image_link
        .endm

; Returns a cell if the point is outside of the image, by bound, which is not 0.
        .macro  find_outside bound, u_floor, v_floor, within
        CFPNE   \v_floor, m_minus_one, image_outside
        CFPNE   \bound, m_two, \within
        CFPEQ   \u_floor, r0, \within
image_outside:
        ES      image_cell, 256
        BIM     0, colour_link
        .endm
        .macro  find_colour
        BIM     0, map_wave
        .endm
        .macro  find_texel
        SHIFTI  texel, 6, texel
        ADDX    map_stops, texel, texel
        ELEN    texel, PIXEL_SIZE
        .endm
        .macro  load_pixel
        AND     texel, p_fraction, texel        ; y_1 may be a machine zero
        find_texel
        SWAP    [texel], image_r, [r0]
        .endm
        .macro  add_pixel
        find_texel
        SWAP    [texel], corner_r, [r0]
        MPYS    corner_r, weight, corner_r
        MPYS    corner_g, weight, corner_g
        MPYS    corner_b, weight, corner_b
        ADDN    image_r, corner_r, image_r
        ADDN    image_g, corner_g, image_g
        ADDN    image_b, corner_b, image_b
        .endm

; bump.s
        .share  local
        .regs   r126, bump_outer, bump_link
        .regs   r128, raw_x, raw_y, raw_z       ; the normal without bumps
        .reg    bump_at, r131
        .regs   r132, bump_value, bump_x, bump_y, bump_z
        .regs   r136, bump_corner, bump_left
        .reg    height_link, r83                ; shares the register of facing
        .regs   r139, bump_sum_x, bump_sum_y, bump_sum_z
        .regs   r142, bump_share
        .regs   r143, bump_from, bump_to, bump_low, bump_rise
        .regs   r51, height_from, height_slope, height_0, height_1, height_2, height_3
        .regs   r58, b0, b1, b2, b3, b4, b5, b6, b7, b8, b9, b10, b11
        .reg    bump_corners_left, r57
        .endshare
        .share  local
        .regs   r48, bump_weight, bump_flag
        .reg    height_at, r41                  ; here
        .endshare

        .macro  change_normal
        copy_three nx, ny, nz, raw_x, raw_y, raw_z
        load_field P_BUMP, bump_at
        IBXEQ   bump_at, r0, r0, not_bumped\@
        apply_bumps
not_bumped\@:
        .endm
        .macro  begin_bumps
        .endm
        .macro  leave_bumped label
        BIM     \label
        .endm

; bump_sum_x .. = the normal between the entries below and above bump_value.
        .macro  sum_of_two_entries
bumped_seek\@:
        load_of bump_at, BUMP_SIZE + BUMP_TO, t1
        CFPLT   bump_value, t1, bumped_between\@
        IX      bump_at, 64 * BUMP_SIZE
        BIM     bumped_seek\@
bumped_between\@:
        load_part bump_at, BUMP_FROM, 4, bump_from
        lowered_scale bump_value, bump_low, bump_rise, bump_share
        not_below_number m_zero, bump_share
        not_above_number m_one, bump_share
        call_bump
        SUBN    m_one, bump_share, t0
        three_by MPYS, t0, lx, ly, lz, bump_sum_x, bump_sum_y, bump_sum_z
        IX      bump_at, 64 * BUMP_SIZE
        call_bump
        scaled_plus lx, bump_share, bump_sum_x, bump_sum_x
        scaled_plus ly, bump_share, bump_sum_y, bump_sum_y
        scaled_plus lz, bump_share, bump_sum_z, bump_sum_z
        .endm

; Loads the height of the map that is the last one not above y_0.
        .macro  each_height next, last
\next:
        IX      height_at, 64 * HEIGHT_SIZE
        LOD     [height_at], t1
        CFPGE   y_0, t1, \next
        IX      height_at, -64 * HEIGHT_SIZE
        load_from height_at, HEIGHT_SIZE, height_from
        .endm
        .macro  set_height next, last
        ADDN    t2, height_0, y_0
        .endm
