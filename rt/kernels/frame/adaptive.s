; adaptive.s - adaptive sampling: the rule, the data of the host, shared macros.
;
; The rule is POV-Ray's +AM1 without jitter. First one ray is traced through the
; middle of each pixel. The row above the band and the column left of it get
; such rays too, although they are no pixels of the picture. Colours differ if
;
;   |r^p - r'^p| + |g^p - g'^p| + |b^p - b'^p| >= threshold,
;   p = assumed_gamma/2.5
;
; The power of a value that is not above 0 is 0. Pixels are visited in blocks of
; up to 32 by 32, row by row within a block. Each visited pixel is compared with
; its left neighbour, then with the neighbour above it. If the two differ, both
; are refined, unless they are refined already. A neighbour in another block is
; not refined in this case. A refined pixel gets samples^2 more rays on a
; regular grid. Its colour becomes the mean
;
;   (c + c_00 + c_01 + .. + c_10 + ..) (1 / (samples^2 + 1))
;
; Pixels that are visited later are compared with this mean. A pixel in another
; block is compared with c. Depth, normal and number remain those of the first
; ray.
;
; A visit may need the mean of an earlier pixel, which is known only after its
; rays have been traced, but a queue needs many rays. So all pixels of the band
; are visited first, with c in place of each unknown mean. Then the refined
; pixels without a mean are traced, queue by queue, and the visits are repeated.
; They are complete when they need no further mean, because then every mean that
; they used was known. Few means are computed but not used in the end.
;
; The data of the pixels are planes, one after another:
;
;   FINE_POWERS    r^p, g^p, b^p
;   FINE_DISTANCE  difference from the pixel to the right and from the pixel
;                  below, computed from c
;   FINE_OF_MEAN   the same differences, computed from the mean if there is one,
;                  else from c
;   FINE_MEAN      red, green, blue
;   FINE_PLACES    list of the pixels to be traced (not indexed by pixel)
;   FINE_TRACED    scalar: a word per pixel, not 0 if it has a mean; vector: a
;                  bit per pixel
;   FINE_REFINED   the same for the pixels that the last visits refined
;
; Source: POV-Ray 3.7, from its code and from measurements of its pictures. The
; method for queues is derived here.

        .equ    FINE_POWERS, 0
        .equ    FINE_DISTANCE, 3
        .equ    FINE_OF_MEAN, 5
        .equ    FINE_MEAN, 7
        .equ    FINE_PLACES, 10
        .equ    FINE_TRACED, 11
        .equ    FINE_REFINED, 12
        .equ    FINE_PLANES, 13
        .equ    FINE_BLOCK, ADAPTIVE    ; pixels across and down, at most 32
        .equ    FINE_STRINGS, 10        ; bit strings of a row, after the planes

        .data
scene_threshold: .word 0                ; a number
scene_wide:     .word 0                 ; columns of the first rays, a number
scene_fine:     .word 0                 ; address of the planes above
scene_sampled:  .word 0                 ; address of the planes of samples
scene_sampled_pixels: .word 0           ; their capacity, in pixels
scene_power:    .word 0.4               ; p
fine_frame:     .word 0                 ; scene_frame of the first rays
fine_pixels:    .word 0                 ; scene_pixels of the first rays
fine_list:      .word 0                 ; address of the list of pixels whose
                                        ; samples are traced; 0: the first rays
fine_count:     .word 0                 ; length of this list
fine_left:      .word 0                 ; entries after this list, untraced
fine_rays:      .word 0                 ; rays of the list; 0: none are left
        .code

; Computes the address of a pixel in plane `number` from its address in plane 0.
        .macro  of_plane pixel, number, address
        ES      \address, \number
        MPYX    fine_stride, \address, \address
        ADDX    \address, \pixel, \address
        .endm

        .macro  load_planes
        load_word fine_pixels, fine_stride
        SHIFTI  fine_stride, 6, fine_stride
        load_word scene_wide, fine_row_step
        FLR     fine_row_step, fine_row_step
        SHIFTI  fine_row_step, 6, fine_row_step
        load_word scene_fine, fine_plane
        .endm

; Records the planes of the first rays, whose address and length are then in
; fine_at and fine_there.
        .macro  begin_refinement work
        load_word scene_frame, fine_at
        load_word scene_pixels, fine_there
        load_word scene_power, exponent
        EX      \work, fine_frame
        STO     [\work], fine_at
        STO     [\work, m_index_one], fine_there
        load_planes
        .endm

; Takes up to scene_sampled_pixels pixels of the list, of which visit_count are
; left.
        .macro  take_pixels work
        load_words fine_list, 2, visit_list, \work ; and the number traced last
        advance_by visit_list, visit_place, visit_place
        load_word scene_sampled_pixels, visit_place
        IBXLE   visit_place, r0, visit_count, fine_some
        RTOR    visit_count, visit_place
fine_some:
        SUBX    visit_count, visit_place, visit_count
        load_word scene_samples, visit_rays
        MPYX    visit_rays, visit_rays, visit_rays
        MPYX    visit_rays, visit_place, visit_rays
        store_words visit_list, 4, fine_list, \work
        store_word visit_rays, scene_pixels, \work
        load_word scene_sampled, visit_list
        store_word visit_list, scene_frame, \work
        .endm

; Loads the data of the means: mean_list and the pixels in it, the number of
; samples and the factor of a sum, the planes of samples and their distance.
        .macro  begin_means unit, work
        load_planes
        load_word scene_power, exponent
        load_words fine_list, 2, mean_list, \work
        load_word scene_samples, mean_samples
        MPYX    mean_samples, mean_samples, mean_samples
        ADDN    mean_samples, r0, mean_share
        ADDN    mean_share, \unit, mean_share
        DIVS    \unit, mean_share, mean_share
        load_word scene_frame, mean_sampled
        load_word scene_pixels, mean_step
        SHIFTI  mean_step, 6, mean_step
        .endm

        .macro  begin_picture
        load_planes
        load_word fine_frame, show_first
        load_word scene_picture, show_picture
        of_plane fine_plane, FINE_MEAN, show_mean
        ES      show_planes_left, FRAME_CHANNELS
        .endm

; Traces all samples after the first rays. trace_levels traces the rays.
        .macro  refine_pixels begin, next, average, end, its_link
        call_routine \begin, \its_link
refine_next:
        call_routine \next, \its_link
        load_word fine_rays, s0
        IBXEQ   s0, r0, r0, refine_done
        call_routine trace_levels, link
        call_routine \average, \its_link
        BIM     refine_next
refine_done:
        call_routine \end, \its_link
        .endm
