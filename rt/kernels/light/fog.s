; fog.s - constant fogs, as both forms of the program have them (FOG = 1).
;
; What a ray sees at a distance d, what comes of its own rays in it, is dimmed by
; each fog, and takes of its colour:
;
;   a = e^(-d / distance), but the fog's transmit at least
;   colour = colour  product of a (1 - filter + filter fog)
;          + sum of (1 - a) fog
;
; A ray that meets nothing sees the background at fog_far.  e^(-d / distance) is
; 2^(d FOG_SCALE); it is found by the second half of the power (power_vector.s).
; Source: POV-Ray 3.7's fog of the type 1, measured by its pictures.

        .record FOG
        .field  FOG_SCALE               ; -1 / (distance ln 2)
        .field  FOG_LEAST               ; transmit
        .field  FOG_COLOR, 3
        .field  FOG_PASS, 3             ; 1 - filter + filter fog
        .endrecord

        .data
scene_fogs:     .word 0                 ; address of the first
scene_fog_count: .word 0                ; at least one
fog_far:        .word 2e10              ; POV-Ray's
        .code
