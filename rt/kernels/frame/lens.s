; lens.s - a camera's lens, which shows sharply what is at one distance.
;
; The rays of a pixel's samples (samples.s) start at as many points L of a disk about
; the location, at right angles to the direction, and meet where the pinhole's ray
; O + t D is at the distance F along the direction of the camera:
;
;   O' = O + L          D' = D - (|direction| / F) L,  brought to length one
;
; (of an orthographic camera, whose D has length one, D - L / F).  Each of a pixel's
; samples has its own point, which is that of its row and column in the pixel; the
; host lays them out (rt/layout/lens.c).
; Source: the thin lens of Cook, Porter and Carpenter, "Distributed Ray
; Tracing" (1984); derived here.

        .data
scene_lens:     .word 0                 ; address of L: x of all samples of a pixel,
                                        ; row by row, then y, then z
scene_focus:    .word 1.0               ; F
        .code
