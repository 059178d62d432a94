; pattern.s - computes the values of patterns, in both forms (PATTERNS = 1).
;
; A pattern has a value v at each point X of the pigment's space.  v is a
; position between the stops of a map.  rt/scene/patterns.def has the formulas;
; in that of a gradient, x is along its axis, and the floor is at least 0.  The
; value of a list is the index of its colour divided by that of the last one.
; All other values are then transformed by a wave:
;
;   w = frequency v + phase, reduced modulo 1.00001 towards 0; or v, if the
;       frequency is 0; w - floor(w) if that is below 0
;   ramp w,  triangle 2 w up to 1/2, then 2 - 2 w,  sine (1 + sin(2 pi w)) / 2,
;   scallop |sin(pi w)|,  cubic (3 - 2 w) w^2,  poly w^exponent
;
; Bricks: x, y, z are increased by the mortar m and k_checker.  With the brick's
; size (w, h, d) and {u} = u - floor(u) there is mortar where
;
;   {y/h} <= m/h,   {x/w + s} <= m/w,   {z/d + 1/2 - s} <= m/d
;
; with s = 0 if {y/(2 h)} <= 1/2, else 1/2.
;
; Hexagons: the nearest node of the lattice k = 2/3 x, a = z / sqrt(3) - x/3 is
; found by three roundings, of k, a and k + a.  If k or a changes most, it is
; computed from the other two.  The value is a - k modulo 3, halved.
;
; sin(2 pi t) = (-1)^n sin(2 pi (t - n/2)),  n = floor(2 t + 1/2), by the
; polynomial of asm/lib/series.s.  Angles: atan by its series up to the 17th
; power below tan(pi/8), within 3e-9; above, of (t - 1) / (t + 1).
; Source: POV-Ray 3.7's patterns and waves, by its documentation, verified by
; its pictures (1.00001 is from these); the nearest hexagon by cube coordinates.

        .data
pattern_constants:
        .word 6.28318530717958647693    ; 2 pi
        .word 0.15915494309189533577    ; 1 / (2 pi)
        .word 0.25
        .word 0.41421356237309504880    ; tan(pi/8)
        .word 1.00001, 0.99999000009999900001   ; 1.00001 and its reciprocal
        .word 0.66666666666666666667    ; 2/3
        .word 0.57735026918962576451    ; 1/sqrt(3)
        .word 0.33333333333333333333
        .word 3.0
        .equ    PATTERN_CONSTANTS, 10
angle_constants:
        .word 0.33333333333333333333    ; 1/3
        .word 0.2
        .word 0.14285714285714285714    ; 1/7
        .word 0.11111111111111111111    ; 1/9
        .word 0.09090909090909090909    ; 1/11
        .word 0.07692307692307692308    ; 1/13
        .word 0.06666666666666666667    ; 1/15
        .word 0.05882352941176470588    ; 1/17
        .equ    ANGLE_CONSTANTS, 8
        .code

; A routine pattern_name sets y_0 to the value at q_x, q_y, q_z and returns to
; inner_link.  y_1 .. y_4, q_x, q_y, q_z are scratch.  In both forms number and
; none are registers for numbers.  pigment_scalar.s and pigment_vector.s define
; the registers, and the macros that differ.

; rest = x - floor(x).
        .macro  fraction x, rest, work
        floor   \x, \work
        normal  \work, \work
        minus   \x, \work, \rest
        .endm

        .macro  less_floor x, work
        fraction \x, \x, \work
        .endm

; y_0 = sin(2 pi y_0).
        .macro  sine_of_turn
        call_routine find_sine, sine_link
        .endm

        .kernel shade
        begin_pattern
find_value:
        load_words pattern_constants, PATTERN_CONSTANTS, turn, number
        RTOR    map_function, target
        BSAVE   inner_link, [target]
        IBXEQ   map_wave, r0, r0, pattern_found
        CFPEQ   map_a, r0, pattern_wave
        line    y_0, map_a, map_b, y_0
        scale   y_0, unwrap, y_1
        truncate y_1, y_1
        normal  y_1, y_1
        minus_scaled y_0, y_1, wrap, y_0
pattern_wave:
        floor   y_0, y_1
        normal  y_1, y_1
        if_less_number y_1, r0, pattern_above
        then_minus y_0, y_1, y_0
        end_if  pattern_above
        RTOR    map_wave, target
        BSAVE   inner_link, [target]            ; continues at pattern_found
wave_ramp:
pattern_found:
        end_pattern

wave_triangle:
        scale   y_0, m_two, y_0
        if_number_less m_one, y_0, wave_rises
        then_from m_two, y_0, y_0
        end_if  wave_rises
        return_wave
wave_sine:
        sine_of_turn
        raised_scale y_0, m_one, m_half, y_0
        return_wave
wave_scallop:
        scale   y_0, m_half, y_0
        sine_of_turn
        absolute y_0, y_0
        return_wave
wave_cubic:
        times   y_0, y_0, y_1
        from_scaled three, y_0, m_two, y_0
        times   y_0, y_1, y_0
        return_wave
wave_poly:
        not_below_number m_tiny, y_0
        raise_value map_c
        return_wave

find_sine:
        line    y_0, m_two, m_half, y_1
        floor   y_1, y_1                        ; half turns
        normal  y_1, y_2
        minus_scaled y_0, y_2, m_half, y_2
        scale   y_2, turn, y_2                  ; r
        times   y_2, y_2, y_3
        sine_polynomial , y_3, y_0
        times   y_0, y_3, y_0
        times   y_0, y_2, y_0
        plus    y_0, y_2, y_0
        if_bit  y_1, m_index_one, sine_even
        then_negate y_0, y_0
        end_if  sine_even
        BIM     0, sine_link

pattern_planar:
        absolute q_y, y_0
pattern_within:
        from    m_one, y_0, y_0
        not_below_number m_zero, y_0
        BIM     0, inner_link
pattern_spherical:
        dot_product q_x, q_y, q_z, q_x, q_y, q_z, y_0, y_1
        root    y_0, y_0
        BIM     pattern_within
pattern_cylindrical:
        times   q_x, q_x, y_0
        times   q_z, q_z, y_1
        plus    y_1, y_0, y_0
        root    y_0, y_0
        BIM     pattern_within
pattern_boxed:
        absolute q_x, y_0
        absolute q_y, y_1
        not_below y_1, y_0
        absolute q_z, y_1
        not_below y_1, y_0
        BIM     pattern_within
pattern_onion:
        dot_product q_x, q_y, q_z, q_x, q_y, q_z, y_0, y_1
        root    y_0, y_0
        less_floor y_0, y_1
        BIM     0, inner_link
pattern_gradient:
        floor   q_x, y_1
        normal  y_1, y_1
        not_below_number m_zero, y_1
        minus   q_x, y_1, y_0
        BIM     0, inner_link
pattern_leopard:
        scale   q_x, per_turn, y_0
        sine_of_turn
        copy    y_0, q_x
        scale   q_y, per_turn, y_0
        sine_of_turn
        plus    y_0, q_x, q_x
        scale   q_z, per_turn, y_0
        sine_of_turn
        sum_scale y_0, q_x, third_part, y_0
        times   y_0, y_0, y_0
        BIM     0, inner_link

; y_0 = the smaller of |x| and |z|, y_1 = the greater.
pattern_radial:
        EX      number, angle_constants
        load_from number, ANGLE_CONSTANTS, angle3
        absolute q_x, y_0
        absolute q_z, y_1
        if_less y_1, y_0, radial_z
        then_absolute q_z, y_0
        then_absolute q_x, y_1
        end_if  radial_z
        if_equal_number y_1, r0, radial_off
        then_set m_one, y_1                     ; on the axis
        end_if  radial_off
        quotient y_0, y_1, y_0
        MPYS    quarter, m_half, number
        ADDN    r0, r0, none
        default none, y_4                       ; turns between it and t
        if_number_less eighth, y_0, radial_series
        lower   y_0, m_one, y_1
        raise   y_0, m_one, y_2
        quotient y_1, y_2, y_2
        then_copy y_2, y_0
        then_set_or number, none, y_4
        end_if  radial_series
        from_product r0, y_0, y_0, y_3
        line    y_3, angle17, angle15, y_2
        step    y_3, angle13, y_2
        step    y_3, angle11, y_2
        step    y_3, angle9, y_2
        step    y_3, angle7, y_2
        step    y_3, angle5, y_2
        step    y_3, angle3, y_2
        step    y_3, m_one, y_2
        times   y_2, y_0, y_0
        scaled_plus y_0, per_turn, y_4, y_0
        if_nearer q_z, q_x, radial_quarter
        then_from quarter, y_0, y_0
        end_if  radial_quarter
        if_less_number q_z, r0, radial_half
        then_from m_half, y_0, y_0
        end_if  radial_half
        if_less_number q_x, r0, radial_found
        then_negate y_0, y_0
        end_if  radial_found
        ADDN    m_half, quarter, number
        raise   y_0, number, y_0
        BIM     0, inner_link

; The value is 0 where the rest y_1 is in the mortar.
        .macro  leave_if_mortar per
        MPYS    map_d, \per, number
        leave_if_number_not_less number, y_1, m_zero, y_0, brick_found
        .endm

        .macro  mortar q, per, shift
        scaled_plus \q, \per, \shift, y_1
        less_floor y_1, y_2
        leave_if_mortar \per
        .endm

pattern_brick:
        ADDN    map_d, m_checker_shift, number
        raise   q_x, number, q_x
        raise   q_y, number, q_y
        raise   q_z, number, q_z
        leaving m_zero, m_one, y_0
        scale   q_y, map_b, y_3
        fraction y_3, y_1, y_2
        leave_if_mortar map_b
        scale   y_3, m_half, y_3
        less_floor y_3, y_2
        default m_zero, y_4                     ; s
        if_number_less m_half, y_3, brick_shifted
        then_set_or m_half, m_zero, y_4
        end_if  brick_shifted
        mortar  q_x, map_a, y_4
        from    m_half, y_4, y_4
        mortar  q_z, map_c, y_4
        staying m_one, y_0
brick_found:
        BIM     0, inner_link

        .macro  nearest_whole x, whole, away
        raise   \x, m_half, \whole
        floor   \whole, \whole
        normal  \whole, \whole
        minus   \whole, \x, \away
        absolute \away, \away
        .endm

; y_4 = the change of k + a minus those of k and a.
pattern_hexagon:
        scale   q_x, two_thirds, q_x            ; k
        scale   q_z, per_root3, q_z
        minus_scaled q_z, q_x, m_half, q_z      ; a
        plus    q_x, q_z, q_y
        nearest_whole q_x, y_0, y_2
        nearest_whole q_z, y_1, y_3
        nearest_whole q_y, y_4, q_x             ; k + a
        minus   y_4, y_0, y_4
        minus   y_4, y_1, y_4
        minus   y_1, y_0, y_0
        if_less y_3, y_2, hexagon_a
        then_negate y_4, y_4                    ; k changes more than a
        then_copy y_2, y_3
        end_if  hexagon_a
        if_less q_x, y_3, hexagon_found
        then_plus y_0, y_4, y_0
        end_if  hexagon_found
        scale   y_0, third_part, y_1
        raise   y_1, m_checker_shift, y_1
        floor   y_1, y_1
        normal  y_1, y_1
        minus_scaled y_0, y_1, three, y_0
        scale   y_0, m_half, y_0
        BIM     0, inner_link

        .if     BUMPS
        .macro  cell_floor q, whole
        raise   \q, m_checker_shift, \whole
        floor   \whole, \whole
        .endm

pattern_checker:
        cell_floor q_x, y_1
        cell_floor q_y, y_2
        cell_floor q_z, y_3
        plus_index y_1, y_2, y_1
        plus_index y_1, y_3, y_1
        default m_zero, y_0
        if_bit  y_1, m_index_one, checker_even
        then_set_or m_one, m_zero, y_0
        end_if  checker_even
        BIM     0, inner_link
        .endif
        .endkernel
