; beam_scalar.s - computes the light of beams and fading lights at a point.  The
; formulas are in beam.s, the order of the operations is that of beam_vector.s.
; These macros and registers are a part of the subroutines that shade.

        .include "light/beam.s"

        .share  local
        .regs   r112, beam_attenuates, beam_parallel, beam_kind
        .regs   r115, beam_x, beam_y, beam_z, beam_narrow, beam_low, beam_steep
        .regs   r121, beam_tightness, beam_fade, beam_power
        .regs   r124, attenuation, beam_off, beam_q, beam_three
        .endshare

; Computes the direction to the light whose beam is light_beam, as beam_vector.s
; does.
;
; In:  lx ly lz = P - X.  Out: lx ly lz = L; light_distance; beam_off = the
;      distance from the axis of a cylinder.
        .macro  beam_towards
        RTOR    light_beam, here
        ELEN    here, BEAM_WORDS
        SWAP    [here], beam_attenuates, [r0]
        IBXNE   beam_parallel, r0, r0, beam_rays\@
        normalise_by m_one, lx, ly, lz, light_distance, t1
        BIM     beam_direction\@
beam_rays\@:
        dot     lx, ly, lz, beam_x, beam_y, beam_z, light_distance, t0
        IBXEQ   beam_kind, r0, r0, beam_axis\@
        MPYS    light_distance, beam_x, t0
        SUBN    lx, t0, lx
        MPYS    light_distance, beam_y, t0
        SUBN    ly, t0, ly
        MPYS    light_distance, beam_z, t0
        SUBN    lz, t0, lz
        dot     lx, ly, lz, lx, ly, lz, beam_off, t0
        SQRT    beam_off, beam_off
beam_axis\@:
        RTOR    beam_x, lx
        RTOR    beam_y, ly
        RTOR    beam_z, lz
beam_direction\@:
        .endm

        .macro  beam_raise base, to
        RTOR    \base, p_x
        RTOR    \to, exponent
        EX      target, power
        BSAVE   power_link, [target]
        .endm

; Computes the attenuation, or branches to none if it is 0.
        .macro  find_attenuation none
        RTOR    m_one, attenuation
        IBXEQ   beam_kind, r0, r0, attenuation_fading\@
        IBXNE   beam_kind, r0, m_index_one, attenuation_cylinder\@
        dot     lx, ly, lz, beam_x, beam_y, beam_z, beam_q, t0
        BIM     attenuation_edge\@
attenuation_cylinder\@:
        CFPGE   r0, light_distance, \none
        MPYS    beam_off, beam_narrow, t0
        SUBN    m_one, t0, beam_q
attenuation_edge\@:
        CFPGE   r0, beam_q, \none
        SUBN    beam_q, beam_low, t0
        MPYS    t0, beam_steep, t0
        CFPGE   t0, r0, attenuation_inside\@
        RTOR    m_zero, t0
attenuation_inside\@:
        CFPGE   m_one, t0, attenuation_on_edge\@
        RTOR    m_one, t0
attenuation_on_edge\@:
        ADDN    m_one, m_two, beam_three
        MPYS    t0, t0, attenuation
        MPYS    t0, m_two, t0
        SUBN    beam_three, t0, t0
        MPYS    t0, attenuation, attenuation
        CFPEQ   beam_tightness, r0, attenuation_fading\@
        beam_raise beam_q, beam_tightness
        MPYS    attenuation, p_x, attenuation
attenuation_fading\@:
        CFPEQ   beam_power, r0, attenuation_found\@
        ABS     light_distance, beam_q
        MPYS    beam_q, beam_fade, beam_q
        CFPGE   m_one, beam_q, attenuation_near\@
        DIVS    m_one, beam_q, t0               ; farther than fade_distance
        beam_raise t0, beam_power
        ADDN    p_x, m_one, t1
        BIM     attenuation_faded\@
attenuation_near\@:
        beam_raise beam_q, beam_power
        ADDN    p_x, m_one, t1
        RTOR    m_one, p_x
attenuation_faded\@:
        MPYS    p_x, m_two, t0
        DIVS    t0, t1, t0
        MPYS    attenuation, t0, attenuation
attenuation_found\@:
        CFPGE   r0, attenuation, \none
        .endm

; Multiplies the light's colour, or its transmitted part, by the attenuation.
        .macro  attenuate_light
        MPYS    attenuation, light_r, light_r
        MPYS    attenuation, light_g, light_g
        MPYS    attenuation, light_b, light_b
        .endm
