; adaptive.s - more rays for the pixels that differ from their neighbours: what the
; host says of it, and the rule, POV-Ray's +AM1 without jitter.
;
; First each pixel gets one ray, through its middle, and so do the row above the
; band and the column left of it, which are no pixels.  Colours c, c' differ if
;
;   |r^p - r'^p| + |g^p - g'^p| + |b^p - b'^p| >= threshold,  p = assumed_gamma/2.5
;
; (of what is not above 0 the power is 0).  The pixels of a block, 32 across and
; down, are visited row by row.  The one that is visited is held against the pixel
; to the left of it, then against that above it.  If it differs from a neighbour,
; both are refined, unless they are so already; a neighbour in another block is
; not refined then.  What is refined gets samples^2 rays more, on a regular grid,
; and its colour is from then on the mean
;
;   (c + c_00 + c_01 + .. + c_10 + ..) (1 / (samples^2 + 1))
;
; with which pixels that are visited later are compared; one in another block is
; compared with c.  Depth, normal and number stay those of the first ray.
;
; The visits are in order, and a mean is known only when its rays have been traced,
; but a queue needs many rays.  So the visits are done for the whole band, with c
; wherever a mean is not known; all that they refine, and has no mean yet, is
; traced, queue by queue; then the visits are done again.  When they want no more
; means, every one that they used was known.  Only few pixels get a mean that is
; not used in the end.
;
; Of each pixel there are, one plane behind the other:
;
;   FINE_POWERS       r^p, g^p, b^p
;   FINE_DISTANCE     from the pixel to the right of it, from that below it, of c
;   FINE_OF_MEAN      the same of its mean, where there is one, else of c
;   FINE_MEAN         red, green, blue
;   FINE_PLACES       (not by pixel) a list of those that are to be traced
;   FINE_TRACED       scalar: words that are not 0 if there is a mean; vector: bits
;   FINE_REFINED      the same of those that the last visits refined
;
; Source: POV-Ray 3.7, read, and measured on its pictures; the way to have it in queues
; is derived here.

        .equ    FINE_POWERS, 0
        .equ    FINE_DISTANCE, 3
        .equ    FINE_OF_MEAN, 5
        .equ    FINE_MEAN, 7
        .equ    FINE_PLACES, 10
        .equ    FINE_TRACED, 11
        .equ    FINE_REFINED, 12
        .equ    FINE_PLANES, 13
        .equ    FINE_BLOCK, ADAPTIVE    ; pixels across and down, 32 at most
        .equ    FINE_STRINGS, 10        ; of bits, a row long, behind the planes

        .data
scene_threshold: .word 0                ; a number
scene_wide:     .word 0                 ; columns of the first rays, a number
scene_fine:     .word 0                 ; address of the planes above
scene_sampled:  .word 0                 ; address of the planes of samples, and of
scene_sampled_pixels: .word 0           ; how many pixels they hold those
scene_power:    .word 0.4               ; p
fine_frame:     .word 0                 ; of the first rays: scene_frame,
fine_pixels:    .word 0                 ; scene_pixels
fine_list:      .word 0                 ; address of the places whose samples are
                                        ; traced; 0: the first rays are
fine_count:     .word 0                 ; how many these are
fine_left:      .word 0                 ; .. are in the list behind them
fine_rays:      .word 0                 ; of them; 0: nothing is left to be traced
        .code

; Where the first ray of column or row k of the first rays' frame goes through a
; frame of samples^2 times as many pixels, in which samples have whole places:
; step k + first, with first = -(samples + 1)/2.
        .macro  first_places unit, a_half, step, first
        ADDN    \step, \unit, \first
        MPYS    \first, \a_half, \first
        SUBN    r0, \first, \first
        .endm

; Address of plane number of a pixel, from that of plane 0 on.
        .macro  of_plane pixel, number, address
        ES      \address, \number
        MPYX    fine_stride, \address, \address
        ADDX    \address, \pixel, \address
        .endm

; All that comes after the first rays, where rays are traced by trace_levels.
        .macro  refine_pixels begin, next, average, end, its_link
        EX      target, \begin
        BSAVE   \its_link, [target]
refine_next:
        EX      target, \next
        BSAVE   \its_link, [target]
        load_word fine_rays, s0
        IBXEQ   s0, r0, r0, refine_done
        EX      target, trace_levels
        BSAVE   link, [target]
        EX      target, \average
        BSAVE   \its_link, [target]
        BIM     refine_next
refine_done:
        EX      target, \end
        BSAVE   \its_link, [target]
        .endm
