; adaptive_vector.s - adaptive sampling (adaptive.s), in vectors.
;
; In, out: as in adaptive_scalar.s.
;
; The visits of a row depend on each other: whether pixel x is refined at its
; visit, c(x), depends on whether its left neighbour was refined. Let
;
;   d, e   x differs from its left neighbour's first ray, from its mean
;   t      x differs from the pixel above it, as that pixel is shown by now
;
; Then c(x) = t(x) or (e(x) if c(x - 1), else d(x)). The first pixel of a block
; always uses d(x). As a function of the bit c(x - 1), c(x) has two values, a0 =
; t or d and a1 = t or e, which are stored. Composing the functions of x - n and
; x gives
;
;   a0(x) := a1(x) if a0(x - n), else a0(x)
;   a1(x) := a1(x) if a1(x - n), else a0(x)
;
; After n = 1, 2, 4, 8, 16 no function depends on a pixel before its block. The
; pixel above is shown by its mean if its c is set, or if its right neighbour
; differed from it. A row of any length takes about thirty bit string
; instructions.
; Source: recurrences by doubling are due to Kogge and Stone (1973). Their use
; for this rule is derived here.

        .share  scratch
        .regs   r233, fine_plane, fine_stride, fine_row_step, fine_at, fine_there
        .regs   r238, fine_next_at, fine_place, mean_list, fine_left_over
        .endshare

; Sets h to the number of elements left, at most QUEUE. Branches to `done` if
; none are left.
        .macro  some_of left, done
        IBXEQ   \left, r0, r0, \done
        at_most QUEUE, \left, s2
        IBXEQ   s2, r0, h, some_as_before\@
        RTOR    s2, h
        call_routine set_hits, link_inner
some_as_before\@:
        .endm

; [distance] = |here - there|, summed over the three powers.
        .macro  begin_distance distance
        VTOV    r0, [\distance]
        .endm

        .macro  add_distance here, there, distance
        SUBNV   [\here], [\there], [v5]
        ABSV    [v5], [v5]
        ADDNV   [\distance], [v5], [\distance]
        .endm

; Stores in two planes the differences of h pixels from those at the distance
; `behind`.
        .macro  first_distance behind, which
        ADDLEN  fine_at, h, s3
        ADDX    s3, \behind, s4
        begin_distance red
        .rept   3
        add_distance s3, s4, red
        ADDX    s3, fine_stride, s3
        ADDX    s4, fine_stride, s4
        .endr
        of_plane fine_at, FINE_DISTANCE + \which, s3
        ADDLEN  s3, h, s3
        VTOV    [red], [s3]
        of_plane fine_at, FINE_OF_MEAN + \which, s3
        ADDLEN  s3, h, s3
        VTOV    [red], [s3]
        .endm

        .kernel average
fine_begin:
        begin_refinement s2
        ES      h, 0
        ES      s2, 3
        MPYX    fine_there, s2, fine_left_over
        RTOR    fine_plane, fine_there
fine_power:
        some_of fine_left_over, fine_powers
        ADDLEN  fine_at, h, s3
        VTOV    [s3], [v0]
        power_of_positive
        ADDLEN  fine_there, h, s3
        VTOV    [v0], [s3]
        advance_by fine_at, h, s2
        advance_by fine_there, h, s2
        SUBX    fine_left_over, h, fine_left_over
        BIM     fine_power
fine_powers:
        RTOR    fine_plane, fine_at
        load_word fine_pixels, fine_left_over
        ES      fine_next_at, 64
fine_distance:
        some_of fine_left_over, fine_begun
        first_distance fine_next_at, 0
        first_distance fine_row_step, 1
        advance_by fine_at, h, s2
        SUBX    fine_left_over, h, fine_left_over
        BIM     fine_distance
fine_begun:
        BIM     0, link

; ---- The visits --------------------------------------------------------------

        .share  scratch
        .regs   r242, visit_columns, visit_down, visit_limit
        .regs   r245, visit_refined, visit_block, visit_work
        .regs   s3, visit_list, visit_place, visit_count, visit_rays
        .endshare
        .share  hits
        .regs   r136, visit_first, visit_d, visit_e, visit_t, visit_a0, visit_a1
        .regs   r142, visit_b0, visit_b1, visit_right, visit_shown
        .regs   visit_d, string0, string1, string2, string3, string4, string5
        .regs   visit_b1, string6, string7, string8
        .endshare

; Allocates bit strings as long as a row of pixels, with zeros before and after
; each string.
        .macro  strings_begin
        of_plane fine_plane, FINE_PLANES, s3
        IX      s3, 64
        ADDLEN  s3, visit_columns, s3
        SHIFTI  visit_columns, -6, s4
        IX      s4, 3
        SHIFTI  s4, 6, s4
        .rept   9
        RTOR    s3, string\+
        ADDX    s3, s4, s3
        .endr
        .endm

; Marks the pixels of a row whose difference, in the plane at `from`, reaches
; the limit.
        .macro  far_apart from, bits
        ADDLEN  \from, visit_columns, \from
        CMPGEV  [\from], visit_limit, [\bits]
        .endm

        .macro  advance_from a0, a1, b0, b1, before
        RTOR    \a0, s2
        IX      s2, -\before
        MASKB   [\a1], [\a0], [\b0] ? [s2]
        RTOR    \a1, s2
        IX      s2, -\before
        MASKB   [\a1], [\a0], [\b1] ? [s2]
        .endm

fine_next:
        load_planes
        load_word fine_left, visit_count
        IBXNE   visit_count, r0, r0, fine_chunk
        load_word scene_threshold, visit_limit
        SHIFTI  fine_row_step, -6, visit_columns
        IX      visit_columns, -1
        strings_begin
        RTOR    s3, visit_first
        ADDLEN  s3, one_index, s3               ; also the start of the next row
        ES      s4, FINE_BLOCK
        MRKO    one_index, s4, [s3]
        of_plane fine_plane, FINE_REFINED, visit_refined
        IX      visit_refined, 1
        ADDLEN  visit_refined, visit_columns, visit_refined
        ADDX    fine_plane, fine_row_step, fine_at
        ES      visit_down, 0
        ES      visit_block, FINE_BLOCK
fine_row:
        SHIFTI  fine_row_step, -6, s2
        ADDX    visit_refined, s2, visit_work
        of_plane fine_at, FINE_DISTANCE, s3
        far_apart s3, visit_d
        of_plane fine_at, FINE_OF_MEAN, s3
        far_apart s3, visit_e
        MASKB   [visit_d], [visit_e], [visit_e] ? [visit_first]
        SUBX    fine_at, fine_row_step, s4
        IX      s4, 64
        of_plane s4, FINE_DISTANCE + 1, s3
        far_apart s3, visit_t
        IBXEQ   visit_down, r0, r0, fine_row_visited
        of_plane s4, FINE_OF_MEAN + 1, s3
        far_apart s3, visit_a0
        MASKB   [visit_a0], [visit_t], [visit_t] ? [visit_shown]
        ORB     [visit_refined], [visit_t], [visit_refined]
fine_row_visited:
        ORB     [visit_t], [visit_d], [visit_a0]
        ORB     [visit_t], [visit_e], [visit_a1]
        advance_from visit_a0, visit_a1, visit_b0, visit_b1, 1
        advance_from visit_b0, visit_b1, visit_a0, visit_a1, 2
        advance_from visit_a0, visit_a1, visit_b0, visit_b1, 4
        advance_from visit_b0, visit_b1, visit_a0, visit_a1, 8
        advance_from visit_a0, visit_a1, visit_b0, visit_b1, 16
        RTOR    visit_b0, s2
        IX      s2, -1
        MASKB   [visit_e], [visit_d], [visit_right] ? [s2]
        RTOR    visit_right, s2
        IX      s2, 1
        RTOR    visit_first, s3
        IX      s3, 1
        ANDNB   [s2], [s3], [visit_shown]
        ORB     [visit_shown], [visit_b0], [visit_shown]
        RTOR    visit_work, visit_refined
        ORB     [visit_shown], [visit_shown], [visit_refined]
        ADDX    fine_at, fine_row_step, fine_at
        IBXNE   visit_down, one_index, visit_block, fine_in_rows, visit_down
        ES      visit_down, 0
fine_in_rows:
        ADDX    fine_plane, fine_stride, s2
        IBXNE   fine_at, r0, s2, fine_row

; Lists the refined pixels that have no mean.
        of_plane fine_plane, FINE_PLACES, fine_there
        store_word fine_there, fine_list, s2
        store_word r0, fine_count, s2
        of_plane fine_plane, FINE_REFINED, visit_refined
        of_plane fine_plane, FINE_TRACED, visit_work
        load_word fine_pixels, fine_left_over
        ES      fine_place, 0
        ES      visit_columns, 0
        ES      h, 0
fine_wanted:
        some_of fine_left_over, fine_listed
        ADDLEN  visit_refined, h, s3
        ADDLEN  visit_work, h, s4
        ANDNB   [s3], [s4], [hits0]
        if_none hits0, s5, fine_unwanted
        INTVLV  fine_place, one_index, [v0]
        RTOR    fine_there, s6
        CPSV    [v0], [s6] ? [hits0]
        ORB     [s4], [hits0], [s4]
        advance_by fine_there, s5, s6
        ADDX    visit_columns, s5, visit_columns
fine_unwanted:
        ADDX    visit_refined, h, visit_refined
        ADDX    visit_work, h, visit_work
        ADDX    fine_place, h, fine_place
        SUBX    fine_left_over, h, fine_left_over
        BIM     fine_wanted
fine_listed:
        RTOR    visit_columns, visit_count

fine_chunk:
        take_pixels s2
        store_word r0, scene_tiles, s2
        BIM     0, link

; ---- Means -------------------------------------------------------------------

        .share  scratch
        .regs   r242, mean_sampled, mean_step, mean_share, mean_samples
        .regs   r246, mean_samples_left, mean_first, mean_planes_left, mean_near, mean_places
        .endshare

; Adds the part of one plane to the differences of h means from the pixels at
; the distance `away`.
        .macro  mean_distance away, distance
        ADDX    mean_near, \away, s3
        VXTOV   [mean_places], [s3], [v6]
        add_distance v0, v6, \distance
        .endm

        .macro  put_distance distance, which
        of_plane fine_plane, FINE_OF_MEAN + \which, s3
        VTOVX   [mean_places], [\distance], [s3]
        .endm

fine_average:
        begin_means one, s2
        ES      h, 0
        ES      fine_next_at, 64
fine_mean:
        some_of fine_left_over, fine_averaged
        ADDLEN  mean_list, h, mean_places
        INTVLV  r0, mean_samples, [at]
        begin_distance px
        begin_distance py
        load_word fine_frame, mean_first
        RTOR    mean_sampled, fine_at
        of_plane fine_plane, FINE_MEAN, fine_there
        RTOR    fine_plane, mean_near
        ES      mean_planes_left, 3
fine_mean_plane:
        VXTOV   [mean_places], [mean_first], [red]
        RTOR    fine_at, fine_place
        RTOR    mean_samples, mean_samples_left
fine_mean_sample:
        VXTOV   [at], [fine_place], [v0]
        ADDNV   [red], [v0], [red]
        IX      fine_place, 64
        IBXNE   mean_samples_left, minus_one_index, r0, fine_mean_sample, mean_samples_left
        MPYSV   [red], mean_share, [v0]
        VTOVX   [mean_places], [v0], [fine_there]
        power_of_positive
        mean_distance fine_next_at, px
        mean_distance fine_row_step, py
        ADDX    mean_first, fine_stride, mean_first
        ADDX    mean_near, fine_stride, mean_near
        ADDX    fine_there, fine_stride, fine_there
        ADDX    fine_at, mean_step, fine_at
        IBXNE   mean_planes_left, minus_one_index, r0, fine_mean_plane, mean_planes_left
        put_distance px, 0
        put_distance py, 1
        advance_by mean_list, h, s2
        MPYX    s2, mean_samples, s2
        ADDX    mean_sampled, s2, mean_sampled
        SUBX    fine_left_over, h, fine_left_over
        BIM     fine_mean
fine_averaged:
        BIM     0, link

; ---- The picture -------------------------------------------------------------

        .share  scratch
        .regs   r242, show_columns, show_picture, show_mean, show_refined
        .regs   r246, show_planes_left, show_first
        .endshare

fine_end:
        begin_picture
        SHIFTI  fine_row_step, -6, show_columns
        IX      show_columns, -1
show_plane:
        of_plane fine_plane, FINE_REFINED, show_refined
        IX      show_refined, 1
        ADDLEN  show_refined, show_columns, show_refined
        RTOR    fine_row_step, fine_at
show_row:
        SHIFTI  fine_row_step, -6, s2
        ADDX    show_refined, s2, show_refined
        ADDX    show_first, fine_at, s3
        IX      s3, 64
        ADDLEN  s3, show_columns, s3
        ADDLEN  show_picture, show_columns, s4
        ES      s2, FRAME_CHANNELS - 3
        IBXLE   show_planes_left, r0, s2, show_words
        ADDX    show_mean, fine_at, s5
        IX      s5, 64
        ADDLEN  s5, show_columns, s5
        MASKV   [s5], [s3], [s4] ? [show_refined]
        BIM     show_next
show_words:
        VTOV    [s3], [s4]
show_next:
        advance_by show_picture, show_columns, s2
        ADDX    fine_at, fine_row_step, fine_at
        IBXNE   fine_at, r0, fine_stride, show_row
        ADDX    show_first, fine_stride, show_first
        ADDX    show_mean, fine_stride, show_mean
        IBXNE   show_planes_left, minus_one_index, r0, show_plane, show_planes_left
        BIM     0, link
        .endkernel
