; samples.s - several rays for each pixel, on a regular grid: data of the host.
;
; Unless adaptive.s selects the pixels, the band is traced in all forms as one
; with scene_samples times the columns and rows. At the end, average.s computes
; its pixels. For samples c_ij in row i and column j of a pixel, and the scene's
; assumed_gamma:
;
;   colour = (c_00^gamma + c_01^gamma + .. + c_10^gamma + ..) (1 / samples^2)
;
; The power of a value that is not above 0 is 0. The terms are added in this
; order, as linear light. Depth, normal and number are those of the sample at
; half of the rows and columns.
; Source: derived here.

        .data
scene_samples:  .word 0                 ; across and down, an integer; 0: one
                                        ; ray, whose result is the pixel
scene_picture:  .word 0                 ; address of the pixels' planes
scene_gamma:    .word 1.0               ; 1: colours are linear
        .code
