; beam.s - lights that do not shine all around, or fade, as both forms of the
; program have them (BEAMS = 1).
;
; The light at P shines along its axis; A is the unit vector against that, towards
; the light.  With parallel rays L = A for all points X, and the distance is
; A . (P - X); of such a light nothing is between it and a point behind it.  What
; comes of its colour to X is
;
;   dim = s(q) q^tightness  2 / (1 + (distance / fade_distance)^fade_power)
;
;   q = L . A                                in a cone (of parallel rays 1),
;       1 - |P - X - A (A . (P - X))| / falloff    in a cylinder,
;                                            but nothing for a point behind it,
;   s(q) = (3 - 2 t) t^2,  t = (q - low) / (high - low), from 0 to 1
;
; and nothing where q is not above 0.  The edge goes from low to high, from the
; cosines of falloff and radius, or from 0 to 1 - radius / falloff.  As the
; power's base is at most 1, the fading is 2 / (1 + u) or 2 u / (1 + u) of
; u = the ratio of the less distance to the greater, to the power.
; A light with an area is a point for all of this.  Only what stands before it is
; asked for from each of its points, and what comes through is the sum of what does
; from them, times their weights.
; Source: POV-Ray 3.7's spotlight, cylinder, parallel, fade_distance, area_light;
; the formulas are in its documentation, and measured by its pictures.

        .record BEAM
        .field  BEAM_DIMS               ; 1: dim is not the same everywhere
        .field  BEAM_PARALLEL           ; 1: its rays are
        .field  BEAM_KIND               ; 0: all around, 1: cone, 2: cylinder
        .field  BEAM_AXIS, 3            ; A
        .field  BEAM_NARROW             ; 1 / falloff, of a cylinder
        .field  BEAM_EDGE, 2            ; low, 1 / (high - low)
        .field  BEAM_TIGHTNESS
        .field  BEAM_FADE, 2            ; 1 / fade_distance; fade_power, or 0: it
                                        ; does not fade
        .if     AREAS
        .field  BEAM_POINTS             ; of its area: the address of the first,
        .field  BEAM_POINT_COUNT        ; or 0; how many
        .endif
        .endrecord
        .equ    BEAM_WORDS, BEAM_FADE + 2       ; the measures

        .if     AREAS
; A point of a light's area; the kernels that bound rays to it take it for the
; light that they go to.
        .record LIGHT_POINT
        .field  LIGHT_POINT_POSITION, 3 ; as LIGHT_POSITION
        .field  LIGHT_POINT_WEIGHT
        .endrecord
        .endif
