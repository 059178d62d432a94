; fog.s - the formulas and the record of constant fogs, for the scalar and the
; vector form (FOG = 1).
;
; Each fog dims the colour that a ray sees at a distance d, including the rays
; spawned there, and adds its own colour:
;
;   a = max(e^(-d / distance), the fog's transmit)
;   colour = colour  product of a (1 - filter + filter fog)
;          + sum of (1 - a) fog
;
; A ray that hits nothing sees the background at fog_far.  e^(-d / distance) is
; 2^(d FOG_SCALE), computed by the second half of the power (power_vector.s).
; Source: POV-Ray 3.7's fog of type 1, verified by its pictures.

        .record FOG
        .field  FOG_SCALE               ; -1 / (distance ln 2)
        .field  FOG_MIN               ; transmit
        .field  FOG_COLOR, 3
        .field  FOG_PASS, 3             ; 1 - filter + filter fog
        .endrecord

        .data
scene_fogs:     .word 0                 ; address of the first
scene_fog_count: .word 0                ; at least one
fog_far:        .word 2e10              ; POV-Ray's value
        .code
