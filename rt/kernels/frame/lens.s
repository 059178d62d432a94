; lens.s - a camera's lens, in focus at one distance.
;
; The rays of a pixel's samples (samples.s) start at points L of a disk around
; the location, perpendicular to the camera's direction, one point for each
; sample. They intersect where the pinhole's ray O + t D is at the distance F
; along the direction of the camera:
;
;   O' = O + L          D' = D - (|direction| / F) L,  normalised
;
; An orthographic camera, whose D has length one, uses D - L / F. The point of a
; sample depends on its row and column within the pixel. The host lays out the
; points (rt/layout/lens.c).
; Source: the thin lens of Cook, Porter and Carpenter, "Distributed Ray Tracing"
; (1984); derived here.

        .data
scene_lens:     .word 0                 ; address of L: x of all samples of a
                                        ; pixel, row by row, then y, then z
scene_focus:    .word 1.0               ; F
        .code
