; beam.s - the formulas and the record of lights that do not shine in all
; directions or that fade, for the scalar and the vector form (BEAMS = 1).
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
