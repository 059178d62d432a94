; samples.s - several rays a pixel, on a regular grid: what the host says of it.
;
; Unless only some pixels have them (adaptive.s), the band is traced as one of
; scene_samples times as many columns and rows, whatever the form; at the end
; average_scalar.s or average_vector.s makes its pixels.  Of one pixel, with samples
; c_ij in rows i and columns j, gamma the scene's assumed_gamma (c above 0, else
; nothing):
;
;   colour = (c_00^gamma + c_01^gamma + .. + c_10^gamma + ..) (1 / samples^2)
;
; added in that order: linear light.  Depth, normal and number are those of the
; sample at half of the rows and columns.
; Source: derived here.

        .data
scene_samples:  .word 0                 ; across and down, an integer; 0: one,
                                        ; which is the pixel
scene_picture:  .word 0                 ; address of the pixels' planes
scene_gamma:    .word 1.0               ; 1: colours are linear
        .code
