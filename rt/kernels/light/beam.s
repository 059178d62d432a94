; beam.s - lights that do not shine in all directions or that fade, in both
; forms (BEAMS = 1).
;
; The light at P shines along its axis; the unit vector A points the opposite
; way, towards the light.  With parallel rays L = A for all points X, and the
; distance is A . (P - X); nothing is between such a light and a point on its
; far side.  The light's colour reaches X with the factor
;
;   attenuation = s(q) q^tightness  2 / (1 + (distance / fade_distance)^fade_power)
;
;   q = L . A                                  for a cone (parallel rays: 1),
;       1 - |P - X - A (A . (P - X))| / falloff    for a cylinder, but 0 for
;                                              a point on its far side,
;   s(q) = (3 - 2 t) t^2,  t = (q - low) / (high - low), from 0 to 1
;
; and 0 if q is not above 0.  The edge goes from low to high: from the cosine of
; falloff to that of radius, or from 0 to 1 - radius / falloff.  The base of the
; power is at most 1.  So the fading is computed as 2 / (1 + u) or
; 2 u / (1 + u), where u is the ratio of the smaller distance to the greater, to
; the power fade_power.
;
; A light with an area is a point light in these formulas.  Only shadows are
; tested from each of its points; the light is the weighted sum of the light
; that arrives from these points.
; Source: POV-Ray 3.7's spotlight, cylinder, parallel, fade_distance,
; area_light; the formulas are in its documentation and were verified by its
; pictures.

        .record BEAM
        .field  BEAM_ATTENUATES         ; 1: the attenuation varies
        .field  BEAM_PARALLEL           ; 1: its rays are parallel
        .field  BEAM_KIND               ; 0: none, 1: cone, 2: cylinder
        .field  BEAM_AXIS, 3            ; A
        .field  BEAM_NARROW             ; 1 / falloff of a cylinder
        .field  BEAM_EDGE, 2            ; low, 1 / (high - low)
        .field  BEAM_TIGHTNESS
        .field  BEAM_FADE, 2            ; 1 / fade_distance; fade_power, or 0:
                                        ; no fading
        .if     AREAS
        .field  BEAM_POINTS             ; address of the points of its area,
        .field  BEAM_POINT_COUNT        ; or 0; their number
        .endif
        .endrecord
        .equ    BEAM_WORDS, BEAM_FADE + 2       ; words that are loaded

        .if     AREAS
; A point of a light's area.  For the kernels that bound rays to it, it is the
; light to which they go.
        .record LIGHT_POINT
        .field  LIGHT_POINT_POSITION, 3 ; as LIGHT_POSITION
        .field  LIGHT_POINT_WEIGHT
        .endrecord
        .endif

; Computes the direction to the light whose beam is light_beam.
;
; In:  lx ly lz = P - X.  Out: lx ly lz = L; light_distance; beam_off = the
;      distance from the axis of a cylinder.
        .macro  find_beam_direction
        RTOR    light_beam, here
        load_from here, BEAM_WORDS, beam_attenuates
        IBXNE   beam_parallel, r0, r0, beam_rays\@
        unit_vector lx, ly, lz, light_distance, t1
        leave_beam beam_direction\@
beam_rays\@:
        dot_numbers lx, ly, lz, beam_x, beam_y, beam_z, light_distance, t1
        IBXEQ   beam_kind, r0, r0, beam_axis\@
        minus_scaled lx, light_distance, beam_x, lx
        minus_scaled ly, light_distance, beam_y, ly
        minus_scaled lz, light_distance, beam_z, lz
        dot_product lx, ly, lz, lx, ly, lz, beam_off, t1
        root    beam_off, beam_off
beam_axis\@:
        copy_three beam_x, beam_y, beam_z, lx, ly, lz, set
beam_direction\@:
        .endm

; Computes the attenuation; where it is 0, there is no light.
        .macro  compute_attenuation none
        set     m_one, attenuation
        IBXEQ   beam_kind, r0, r0, attenuation_fading\@
        IBXNE   beam_kind, r0, m_index_one, attenuation_cylinder\@
        dot_numbers lx, ly, lz, beam_x, beam_y, beam_z, beam_q, t1
        BIM     attenuation_edge\@
attenuation_cylinder\@:
        from_scaled m_one, beam_off, beam_narrow, beam_q
        darken_far_side \none
attenuation_edge\@:
        darken_unless_above_0 beam_q, \none
        lowered_scale beam_q, beam_low, beam_steep, t1
        not_below_number m_zero, t1
        not_above_number m_one, t1
        times   t1, t1, attenuation
        ADDN    m_one, m_two, beam_three
        from_scaled beam_three, t1, m_two, t1
        times   t1, attenuation, attenuation
        CFPEQ   beam_tightness, r0, attenuation_fading\@
        copy_lit beam_q, p_x
        power_of beam_tightness
        times   attenuation, p_x, attenuation
attenuation_fading\@:
        CFPEQ   beam_power, r0, attenuation_found\@
        absolute light_distance, beam_q
        scale   beam_q, beam_fade, beam_q
        smaller_to_greater                      ; p_x = beam_q, or 1 / beam_q
        power_of beam_power
        raise   p_x, m_one, t1
        one_where_near p_x
        scale   p_x, m_two, t0
        quotient t0, t1, t0
        times   attenuation, t0, attenuation
attenuation_found\@:
        darken_unless_above_0 attenuation, \none
        .endm
