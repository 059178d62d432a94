; pigment_scalar.s - selects the colour of a primitive's pigment at a point.
;
;       CALL PIGMENT_CELL (POINT, PRIMITIVE, CELL)
;
; POINT = x, y, z (3 words); PRIMITIVE = its record; CELL = the offset of the
; colour from the first one, in bits, at four words per colour: 0, or 256 in
; every other cell of a checker, and outside of a bounded image (pigment.s).

        .include "light/pigment.s"

        .share  local
        .regs   r32, a_point, primitive, a_cell
        .regs   r40, link_saved, here
        .regs   r48, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9
        .regs   r58, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10
        .regs   r69, sh11, sh12, sh13, sh14, sh15
        .regs   r74, px, py, pz
        .regs   r77, cell
        .regs   sh0, m00, m01, m02, m03, m10, m11, m12, m13, m20, m21, m22, m23
        .regs   sh6, stop_at, stop_scale, stop_r, stop_g, stop_b, rise_r, rise_g
        .reg    rise_b, sh13
        .regs   r78, a_color, color0r, color0g, color0b
        .regs   color0r, cr, cg, cb
        .if     IMAGES
        .regs   r126, image_cell, image_link
        .endif
        .endshare
        .if     IMAGES
        .equ    PIGMENT_REGISTERS, 96
        .equ    SKY_REGISTERS, 96
        .elseif PATTERNS
        .equ    PIGMENT_REGISTERS, 46
        .equ    SKY_REGISTERS, 93
        .else
        .equ    PIGMENT_REGISTERS, 46
        .equ    SKY_REGISTERS, 50
        .endif

        .data
pigment_save:   .space SKY_REGISTERS
        .code

; Computes cell.  Branches to plain or to gradient if the pigment is no checker.
        .macro  checker_cell plain, gradient
        ES      cell, 0
        load_field P_PIGMENT, t0
        IBXEQ   t0, r0, r0, \plain
        IBXNE   t0, r0, m_index_one, \gradient
        checker_floors
        plus_index t2, t4, t2
        AND     t2, m_index_one, t2
        SHIFTI  t2, 8, cell
        .endm

; Computes color0 at the point.  sh0 .. sh5 = the words of a gradient, P_PATTERN
; or scene_sky.
        .macro  gradient_colour
        gradient_value
        map_colour
        .endm

; Computes color0 of the value t0 by the map of sh5 stops after the first, at
; sh4.
        .macro  map_colour
        RTOR    sh4, here
map_next\@:
        IX      here, 64 * STOP_SIZE
        LOD     [here], t1
        CFPLT   t0, t1, map_between\@
        IBXNE   sh5, m_index_minus_one, r0, map_next\@, sh5
        IX      here, 64 * STOP_SIZE
map_between\@:
        IX      here, -64 * STOP_SIZE
        load_from here, STOP_SIZE, stop_at
        colour_between_stops
        .endm

        .if     PATTERNS
        .share  local
        .regs   r95, q_x, q_y, q_z, pattern_link, inner_link, sine_link
        .regs   r101, y_0, y_1, y_2, y_3, y_4, number
        .regs   r107, map_function, map_wave, map_a, map_b, map_c, map_d
        .regs   r113, map_stops, map_stop_count
        .regs   r115, turn, per_turn, quarter, eighth, wrap, unwrap
        .regs   r121, two_thirds, per_root3, third_part, three
        .regs   r64, angle3, angle5, angle7, angle9, angle11, angle13, angle15
        .reg    angle17, r71
        .reg    none, m_zero
        .regs   y_0, image_r, image_g, image_b, image_work, last_column
        .reg    colour_link, pattern_link
        .endshare

; Computes color0 at the point.  sh0 .. = P_PATTERN, map_function .. = P_MAP.
        .macro  pattern_colour
        pattern_point
        .if     IMAGES
        ES      image_cell, 0
        .endif
        call_routine find_value, pattern_link
        .if     IMAGES
        IBXNE   map_stop_count, r0, r0, pattern_mapped\@
        copy_three y_0, y_1, y_2, color0r, color0g, color0b
        BIM     pattern_coloured\@
pattern_mapped\@:
        .endif
        RTOR    y_0, t0
        RTOR    map_stops, sh4
        RTOR    map_stop_count, sh5
        map_colour
        .if     IMAGES
pattern_coloured\@:
        .endif
        .endm

        .macro  begin_pattern
        .endm

        .macro  end_pattern
        BIM     0, pattern_link
        .endm

        .macro  return_wave
        BIM     0, pattern_link
        .endm

        .macro  raise_value to
        RTOR    y_0, p_x
        RTOR    \to, exponent
        call_routine power, power_link
        RTOR    p_x, y_0
        .endm
        .endif

        .kernel shade
pigment_cell:
        store_words r32, PIGMENT_REGISTERS, pigment_save
        load_from arguments, 3, a_point
        SWAP    [a_point], px, [r0]
        .if     IMAGES
        checker_cell pigment_found, pigment_image
        BIM     pigment_found
pigment_image:
        call_routine find_image_cell, image_link
        .else
        checker_cell pigment_found, pigment_found
        .endif
pigment_found:
        STO     [a_cell], cell
        leave   pigment_save, PIGMENT_REGISTERS
        .endkernel

        .if     PATTERNS
        .include "light/pattern.s"
        .endif
        .if     IMAGES
        .include "light/image.s"
        .endif
