; beam_scalar.s - computes the light of beams and fading lights at a point.  The
; formulas are in beam.s, the order of the operations is that of beam_vector.s.
; These macros and registers are a part of the subroutines that shade.

        .include "light/beam.s"

        .share  local
        .regs   r112, beam_dims, beam_parallel, beam_kind
        .regs   r115, beam_x, beam_y, beam_z, beam_narrow, beam_low, beam_steep
        .regs   r121, beam_tightness, beam_fade, beam_power
        .regs   r124, dim, beam_off, beam_q, beam_three
        .endshare

; Computes the direction to the light whose beam is light_beam, as beam_vector.s
; does.
;
; In:  lx ly lz = P - X.  Out: lx ly lz = L; light_distance; beam_off = the
;      distance from the axis of a cylinder.
        .macro  beam_towards
        RTOR    light_beam, here
        ELEN    here, BEAM_WORDS
        SWAP    [here], beam_dims, [r0]
        IBXNE   beam_parallel, r0, r0, beam_rays\@
        normalise_by m_one, lx, ly, lz, light_distance, t1
        BIM     beam_way\@
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
beam_way\@:
        .endm

        .macro  beam_raise base, to
        RTOR    \base, p_x
        RTOR    \to, exponent
        EX      target, power
        BSAVE   power_link, [target]
        .endm

; Computes dim, or branches to none if it is 0.
        .macro  find_dim none
        RTOR    m_one, dim
        IBXEQ   beam_kind, r0, r0, dim_fading\@
        IBXNE   beam_kind, r0, m_index_one, dim_cylinder\@
        dot     lx, ly, lz, beam_x, beam_y, beam_z, beam_q, t0
        BIM     dim_edge\@
dim_cylinder\@:
        CFPGE   r0, light_distance, \none
        MPYS    beam_off, beam_narrow, t0
        SUBN    m_one, t0, beam_q
dim_edge\@:
        CFPGE   r0, beam_q, \none
        SUBN    beam_q, beam_low, t0
        MPYS    t0, beam_steep, t0
        CFPGE   t0, r0, dim_inside\@
        RTOR    m_zero, t0
dim_inside\@:
        CFPGE   m_one, t0, dim_on_edge\@
        RTOR    m_one, t0
dim_on_edge\@:
        ADDN    m_one, m_two, beam_three
        MPYS    t0, t0, dim
        MPYS    t0, m_two, t0
        SUBN    beam_three, t0, t0
        MPYS    t0, dim, dim
        CFPEQ   beam_tightness, r0, dim_fading\@
        beam_raise beam_q, beam_tightness
        MPYS    dim, p_x, dim
dim_fading\@:
        CFPEQ   beam_power, r0, dim_found\@
        ABS     light_distance, beam_q
        MPYS    beam_q, beam_fade, beam_q
        CFPGE   m_one, beam_q, dim_near\@
        DIVS    m_one, beam_q, t0               ; farther than fade_distance
        beam_raise t0, beam_power
        ADDN    p_x, m_one, t1
        BIM     dim_faded\@
dim_near\@:
        beam_raise beam_q, beam_power
        ADDN    p_x, m_one, t1
        RTOR    m_one, p_x
dim_faded\@:
        MPYS    p_x, m_two, t0
        DIVS    t0, t1, t0
        MPYS    dim, t0, dim
dim_found\@:
        CFPGE   r0, dim, \none
        .endm

; Multiplies the light's colour, or its transmitted part, by dim.
        .macro  dim_light
        MPYS    dim, light_r, light_r
        MPYS    dim, light_g, light_g
        MPYS    dim, light_b, light_b
        .endm
