; pattern_scalar.s - computes the value of a pattern at a point.  The formulas
; are in pattern.s, the order of the operations is that of pattern_vector.s.
; This is a fast routine of the subroutines that compute a pigment: arguments,
; constants and result are in registers, and BSAVE pattern_link calls it.

        .share  local
        .regs   r95, q_x, q_y, q_z, pattern_link, inner_link, sine_link
        .regs   r101, y_0, y_1, y_2, y_3, y_4, y_5
        .regs   r107, map_function, map_wave, map_a, map_b, map_c, map_d
        .regs   r113, map_stops, map_stop_count
        .regs   r115, turn, per_turn, sin15, quarter, eighth, wrap, unwrap
        .regs   r122, two_thirds, per_root3, third_part, three
        .endshare

; x := x - floor(x).
        .macro  less_floor x, work
        FLR     \x, \work
        ADDN    \work, r0, \work
        SUBN    \x, \work, \x
        .endm

        .macro  not_below_0 x
        CFPGE   \x, r0, not_below\@
        RTOR    m_zero, \x
not_below\@:
        .endm

        .macro  greater_of x, y
        CFPGE   \x, \y, greater\@
        RTOR    \y, \x
greater\@:
        .endm

; Computes color0 at the point.  sh0 .. = P_PATTERN, map_function .. = P_MAP.
        .macro  pattern_colour
        pattern_axis sh0, sh1, sh2, sh3, q_x
        pattern_axis sh4, sh5, sh6, sh7, q_y
        pattern_axis sh8, sh9, sh10, sh11, q_z
        .if     IMAGES
        ES      image_cell, 0
        .endif
        EX      target, find_pattern
        BSAVE   pattern_link, [target]
        .if     IMAGES
        IBXNE   map_stop_count, r0, r0, pattern_mapped\@
        RTOR    y_0, color0r
        RTOR    y_1, color0g
        RTOR    y_2, color0b
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

        .macro  pattern_axis k0, k1, k2, k3, q
        dot     px, py, pz, \k0, \k1, \k2, \q, t0
        ADDN    \q, \k3, \q
        .endm

        .kernel shade
find_pattern:
        EX      y_0, pattern_constants
        ELEN    y_0, PATTERN_CONSTANTS
        SWAP    [y_0], turn, [r0]
        RTOR    map_function, target
        BSAVE   inner_link, [target]
        IBXEQ   map_wave, r0, r0, pattern_found
        CFPEQ   map_a, r0, pattern_wave
        MPYS    y_0, map_a, y_0
        ADDN    y_0, map_b, y_0
        MPYS    y_0, unwrap, y_1
        TRU     y_1, y_1
        ADDN    y_1, r0, y_1
        MPYS    y_1, wrap, y_1
        SUBN    y_0, y_1, y_0
pattern_wave:
        FLR     y_0, y_1
        ADDN    y_1, r0, y_1
        CFPGE   y_1, r0, pattern_above
        SUBN    y_0, y_1, y_0
pattern_above:
        RTOR    map_wave, target
        BSAVE   inner_link, [target]            ; continues at pattern_found
wave_ramp:
pattern_found:
        BIM     0, pattern_link

wave_triangle:
        MPYS    y_0, m_two, y_0
        CFPGE   m_one, y_0, pattern_found
        SUBN    m_two, y_0, y_0
        BIM     pattern_found
wave_sine:
        EX      target, find_sine
        BSAVE   sine_link, [target]
        ADDN    y_0, m_one, y_0
        MPYS    y_0, m_half, y_0
        BIM     pattern_found
wave_scallop:
        MPYS    y_0, m_half, y_0
        EX      target, find_sine
        BSAVE   sine_link, [target]
        ABS     y_0, y_0
        BIM     pattern_found
wave_cubic:
        MPYS    y_0, y_0, y_1
        MPYS    y_0, m_two, y_0
        SUBN    three, y_0, y_0
        MPYS    y_0, y_1, y_0
        BIM     pattern_found
wave_poly:
        CFPGE   y_0, m_tiny, wave_poly_of
        RTOR    m_tiny, y_0
wave_poly_of:
        RTOR    y_0, p_x
        RTOR    map_c, exponent
        EX      target, power
        BSAVE   power_link, [target]
        RTOR    p_x, y_0
        BIM     pattern_found

; y_0 = sin(2 pi y_0).
find_sine:
        ADDN    y_0, m_half, y_1
        FLR     y_1, y_1
        ADDN    y_1, r0, y_1
        SUBN    y_0, y_1, y_2
        ABS     y_2, y_3
        CFPGE   quarter, y_3, sine_near
        SUBN    m_half, y_3, y_3
sine_near:
        CFPGE   y_2, r0, sine_above
        SUBN    r0, y_3, y_3
sine_above:
        MPYS    y_3, turn, y_2
        MPYS    y_2, y_2, y_3
        SUBN    r0, y_3, y_3
        horner_start y_3, sin15, exp13
        horner  y_3, exp11
        horner  y_3, exp9
        horner  y_3, exp7
        horner  y_3, exp5
        horner  y_3, exp3
        horner  y_3, m_one
        MPYS    p_x, y_2, y_0
        BIM     0, sine_link

; The routines of the functions return their value in y_0.
pattern_planar:
        ABS     q_y, y_0
pattern_within:
        SUBN    m_one, y_0, y_0
        not_below_0 y_0
        BIM     0, inner_link
pattern_spherical:
        dot     q_x, q_y, q_z, q_x, q_y, q_z, y_0, y_1
        SQRT    y_0, y_0
        BIM     pattern_within
pattern_cylindrical:
        MPYS    q_x, q_x, y_0
        MPYS    q_z, q_z, y_1
        ADDN    y_1, y_0, y_0
        SQRT    y_0, y_0
        BIM     pattern_within
pattern_boxed:
        ABS     q_x, y_0
        ABS     q_y, y_1
        greater_of y_0, y_1
        ABS     q_z, y_1
        greater_of y_0, y_1
        BIM     pattern_within
pattern_onion:
        dot     q_x, q_y, q_z, q_x, q_y, q_z, y_0, y_1
        SQRT    y_0, y_0
        less_floor y_0, y_1
        BIM     0, inner_link
pattern_gradient:
        FLR     q_x, y_1
        ADDN    y_1, r0, y_1
        not_below_0 y_1
        SUBN    q_x, y_1, y_0
        BIM     0, inner_link
pattern_leopard:
        MPYS    q_x, per_turn, y_0
        EX      target, find_sine
        BSAVE   sine_link, [target]
        RTOR    y_0, q_x
        MPYS    q_y, per_turn, y_0
        BSAVE   sine_link, [target]
        ADDN    y_0, q_x, q_x
        MPYS    q_z, per_turn, y_0
        BSAVE   sine_link, [target]
        ADDN    y_0, q_x, y_0
        MPYS    y_0, third_part, y_0
        MPYS    y_0, y_0, y_0
        BIM     0, inner_link

pattern_radial:
        ABS     q_x, y_0
        ABS     q_z, y_1
        RTOR    m_zero, y_5                     ; 1: |x| is greater
        CFPGE   y_1, y_0, radial_z
        RTOR    y_0, y_2
        RTOR    y_1, y_0
        RTOR    y_2, y_1
        RTOR    m_one, y_5
radial_z:
        CFPNE   y_1, r0, radial_off
        RTOR    m_one, y_1
radial_off:
        DIVS    y_0, y_1, y_0
        RTOR    m_zero, y_4                     ; 1: beyond tan(pi/8)
        CFPGE   eighth, y_0, radial_series
        SUBN    y_0, m_one, y_1
        ADDN    y_0, m_one, y_2
        DIVS    y_1, y_2, y_0
        RTOR    m_one, y_4
radial_series:
        MPYS    y_0, y_0, y_3
        SUBN    r0, y_3, y_3
        log_series y_3, m_one
        MPYS    p_x, y_0, y_0
        MPYS    y_0, per_turn, y_0
        CFPEQ   y_4, r0, radial_octant
        MPYS    quarter, m_half, y_1
        ADDN    y_0, y_1, y_0
radial_octant:
        CFPEQ   y_5, r0, radial_quarter
        SUBN    quarter, y_0, y_0
radial_quarter:
        CFPGE   q_z, r0, radial_half
        SUBN    m_half, y_0, y_0
radial_half:
        CFPGE   q_x, r0, radial_found
        SUBN    r0, y_0, y_0
radial_found:
        ADDN    m_half, quarter, y_1
        ADDN    y_0, y_1, y_0
        BIM     0, inner_link

; Branches to there if {q per + shift} <= mortar per.
        .macro  mortar q, per, shift, there
        MPYS    \q, \per, y_1
        ADDN    y_1, \shift, y_1
        less_floor y_1, y_2
        MPYS    map_d, \per, y_2
        CFPGE   y_2, y_1, \there
        .endm

pattern_brick:
        ADDN    map_d, m_checker_shift, y_1
        ADDN    q_x, y_1, q_x
        ADDN    q_y, y_1, q_y
        ADDN    q_z, y_1, q_z
        MPYS    q_y, map_b, y_3
        RTOR    y_3, y_1
        less_floor y_1, y_2
        MPYS    map_d, map_b, y_2
        RTOR    m_zero, y_0
        CFPGE   y_2, y_1, brick_found
        MPYS    y_3, m_half, y_3
        less_floor y_3, y_2
        RTOR    m_zero, y_4                     ; s
        CFPGE   m_half, y_3, brick_shifted
        RTOR    m_half, y_4
brick_shifted:
        mortar  q_x, map_a, y_4, brick_found
        SUBN    m_half, y_4, y_4
        mortar  q_z, map_c, y_4, brick_found
        RTOR    m_one, y_0
brick_found:
        BIM     0, inner_link

        .macro  nearest_whole x, whole, away
        ADDN    \x, m_half, \whole
        FLR     \whole, \whole
        ADDN    \whole, r0, \whole
        SUBN    \whole, \x, \away
        ABS     \away, \away
        .endm

pattern_hexagon:
        MPYS    q_x, two_thirds, q_x            ; k
        MPYS    q_z, per_root3, q_z
        MPYS    q_x, m_half, y_1
        SUBN    q_z, y_1, q_z                   ; a
        ADDN    q_x, q_z, q_y
        nearest_whole q_x, y_0, y_2
        nearest_whole q_z, y_1, y_3
        nearest_whole q_y, y_4, y_5             ; k + a
        CFPGE   y_3, y_2, hexagon_a
        CFPGE   y_5, y_2, hexagon_found
        SUBN    y_4, y_1, y_0
        BIM     hexagon_found
hexagon_a:
        CFPGE   y_5, y_3, hexagon_found
        SUBN    y_4, y_0, y_1
hexagon_found:
        SUBN    y_1, y_0, y_0
        MPYS    y_0, third_part, y_1
        ADDN    y_1, m_checker_shift, y_1
        FLR     y_1, y_1
        ADDN    y_1, r0, y_1
        MPYS    y_1, three, y_1
        SUBN    y_0, y_1, y_0
        MPYS    y_0, m_half, y_0
        BIM     0, inner_link

        .if     BUMPS
        .macro  cell_floor q, whole
        ADDN    \q, m_checker_shift, \whole
        FLR     \whole, \whole
        .endm

pattern_checker:
        cell_floor q_x, y_0
        cell_floor q_y, y_1
        cell_floor q_z, y_2
        ADDU    y_0, y_1, y_0
        ADDU    y_0, y_2, y_0
        AND     y_0, m_index_one, y_1
        RTOR    m_zero, y_0
        IBXEQ   y_1, r0, r0, checker_even
        RTOR    m_one, y_0
checker_even:
        BIM     0, inner_link
        .endif
        .endkernel
