; adaptive_scalar.s - adaptive sampling (adaptive.s), pixel by pixel.
;
; The operations and their order are those of adaptive_vector.s. The vector form
; visits pixels in another order with the same result.
;
; fine_begin:    In: the planes of the first rays.  Out: powers, differences.
; fine_next:     Out: fine_rays, to be traced as the pixels of a band.
; fine_average:  In: the planes of these rays.  Out: means, their differences.
; fine_end:      Out: the planes at scene_picture.
;
; All are called by link, and may overwrite the registers of subroutines.

        .share  local
        .regs   r32, fine_plane, fine_stride, fine_row_step, fine_pixel
        .regs   r36, fine_end_at, fine_at, fine_there, fine_word, fine_sum
        .regs   r41, fine_distance_at, fine_limit
        .endshare

; Stores at fine_distance_at the difference of the three powers at fine_at,
; whose planes have the distance `step`, from those of the pixel at fine_there.
        .macro  find_distance step
        RTOR    m_zero, fine_sum
        .rept   3
        LOD     [fine_at], fine_word
        LOD     [fine_there], third
        SUBN    fine_word, third, fine_word
        ABS     fine_word, fine_word
        ADDN    fine_sum, fine_word, fine_sum
        ADDX    fine_at, \step, fine_at
        ADDX    fine_there, fine_stride, fine_there
        .endr
        STO     [fine_distance_at], fine_sum
        .endm

        .kernel average
fine_begin:
        begin_refinement fine_word
        ES      fine_word, 3
        MPYX    fine_stride, fine_word, fine_end_at
        ADDX    fine_end_at, fine_at, fine_end_at
        of_plane fine_plane, FINE_POWERS, fine_there
fine_power:
        LOD     [fine_at], p_x
        power_of_positive
        STO     [fine_there], p_x
        IX      fine_at, 64
        IX      fine_there, 64
        IBXNE   fine_at, r0, fine_end_at, fine_power
        RTOR    fine_plane, fine_pixel
        ADDX    fine_plane, fine_stride, fine_end_at
fine_distance:
        RTOR    fine_pixel, fine_at
        address_of fine_pixel, 1, fine_there
        of_plane fine_pixel, FINE_DISTANCE, fine_distance_at
        find_distance fine_stride
        of_plane fine_pixel, FINE_OF_MEAN, fine_distance_at
        STO     [fine_distance_at], fine_sum
        RTOR    fine_pixel, fine_at
        ADDX    fine_pixel, fine_row_step, fine_there
        of_plane fine_pixel, FINE_DISTANCE + 1, fine_distance_at
        find_distance fine_stride
        of_plane fine_pixel, FINE_OF_MEAN + 1, fine_distance_at
        STO     [fine_distance_at], fine_sum
        IX      fine_pixel, 64
        IBXNE   fine_pixel, r0, fine_end_at, fine_distance
        BIM     0, link

; ---- The visits --------------------------------------------------------------

        .share  local
        .regs   r43, visit_refined, visit_across, visit_down, visit_row_end
        .regs   r47, visit_list, visit_place, visit_count, visit_rays
        .regs   r51, visit_two, visit_block
        .endshare

; Compares the visited pixel with the neighbour at the distance `back` before
; it. `within` is 0 if the neighbour is in another block.
        .macro  visit_neighbour back, which, within
        SUBX    fine_pixel, \back, fine_word
        of_plane fine_word, FINE_REFINED, fine_at
        of_plane fine_word, FINE_DISTANCE + \which, fine_there
        IBXEQ   \within, r0, r0, visit_first\@
        LOD     [fine_at], fine_word
        IBXEQ   fine_word, r0, r0, visit_first\@
        ADDX    fine_there, visit_two, fine_there
visit_first\@:
        LOD     [fine_there], fine_word
        CFPLT   fine_word, fine_limit, visit_equal\@
        ES      visit_refined, 1
        IBXEQ   \within, r0, r0, visit_equal\@
        STO     [fine_at], m_index_one
visit_equal\@:
        .endm

fine_next:
        load_planes
        load_words fine_left, 1, visit_count
        IBXNE   visit_count, r0, r0, fine_chunk
        load_words scene_threshold, 1, fine_limit
        ADDX    fine_stride, fine_stride, visit_two
        ES      visit_block, FINE_BLOCK
        of_plane fine_plane, FINE_REFINED, fine_at
        ADDX    fine_at, fine_stride, fine_end_at
visit_none:
        STO     [fine_at], r0
        IX      fine_at, 64
        IBXNE   fine_at, r0, fine_end_at, visit_none
        ADDX    fine_plane, fine_stride, fine_end_at
        ADDX    fine_plane, fine_row_step, fine_pixel
        ES      visit_down, 0
visit_row:
        ADDX    fine_pixel, fine_row_step, visit_row_end
        IX      fine_pixel, 64
        ES      visit_across, 0
        ES      fourth, 64
visit_pixel:
        ES      visit_refined, 0
        visit_neighbour fourth, 0, visit_across
        visit_neighbour fine_row_step, 1, visit_down
        IBXEQ   visit_refined, r0, r0, visit_next
        of_plane fine_pixel, FINE_REFINED, fine_at
        STO     [fine_at], m_index_one
visit_next:
        IBXNE   visit_across, m_index_one, visit_block, visit_in_block, visit_across
        ES      visit_across, 0
visit_in_block:
        IX      fine_pixel, 64
        IBXNE   fine_pixel, r0, visit_row_end, visit_pixel
        IBXNE   visit_down, m_index_one, visit_block, visit_in_rows, visit_down
        ES      visit_down, 0
visit_in_rows:
        IBXNE   fine_pixel, r0, fine_end_at, visit_row

; Lists the refined pixels that have no mean.
        of_plane fine_plane, FINE_REFINED, fine_at
        ADDX    fine_at, fine_stride, fine_end_at
        of_plane fine_plane, FINE_TRACED, fine_there
        of_plane fine_plane, FINE_PLACES, visit_list
        store_word visit_list, fine_list, fine_pixel
        store_word r0, fine_count, fine_pixel
        ES      visit_place, 0
        ES      visit_count, 0
visit_wanted:
        LOD     [fine_at], fine_word
        LOD     [fine_there], visit_rays
        IBXEQ   fine_word, r0, visit_rays, visit_unwanted
        IBXEQ   fine_word, r0, r0, visit_unwanted
        STO     [fine_there], m_index_one
        STO     [visit_list], visit_place
        IX      visit_list, 64
        IX      visit_count, 1
visit_unwanted:
        IX      visit_place, 1
        IX      fine_there, 64
        IX      fine_at, 64
        IBXNE   fine_at, r0, fine_end_at, visit_wanted

fine_chunk:
        take_pixels fine_at
        BIM     0, link

; ---- Means -------------------------------------------------------------------

        .share  local
        .regs   r43, mean_list, mean_left, mean_share, mean_sampled, mean_step
        .regs   r48, mean_first, mean_samples, mean_samples_left, mean_sample
        .regs   r52, mean_planes_left, mean_power
        .endshare

        .data
mean_powers:    .space 3
        .code

; Computes the difference of a mean from the pixel at the distance `away`.
        .macro  mean_distance away, which
        EX      fine_at, mean_powers
        ADDX    fine_pixel, \away, fine_there
        of_plane fine_pixel, FINE_OF_MEAN + \which, fine_distance_at
        ES      mean_power, 64
        find_distance mean_power
        .endm

fine_average:
        begin_means m_one, fine_at
        load_words fine_frame, 1, mean_first
fine_mean:
        LOD     [mean_list], fine_pixel
        SHIFTI  fine_pixel, 6, fine_pixel
        ADDX    mean_first, fine_pixel, fine_at
        ADDX    fine_plane, fine_pixel, fine_pixel
        of_plane fine_pixel, FINE_MEAN, fine_there
        RTOR    mean_sampled, fine_end_at
        EX      mean_power, mean_powers
        ES      mean_planes_left, 3
fine_mean_plane:
        LOD     [fine_at], fine_sum
        RTOR    fine_end_at, mean_sample
        RTOR    mean_samples, mean_samples_left
fine_mean_sample:
        LOD     [mean_sample], fine_word
        ADDN    fine_sum, fine_word, fine_sum
        IX      mean_sample, 64
        IBXNE   mean_samples_left, m_index_minus_one, r0, fine_mean_sample, mean_samples_left
        MPYS    fine_sum, mean_share, p_x
        STO     [fine_there], p_x
        power_of_positive
        STO     [mean_power], p_x
        IX      mean_power, 64
        ADDX    fine_at, fine_stride, fine_at
        ADDX    fine_there, fine_stride, fine_there
        ADDX    fine_end_at, mean_step, fine_end_at
        IBXNE   mean_planes_left, m_index_minus_one, r0, fine_mean_plane, mean_planes_left
        ES      mean_sample, 64
        mean_distance mean_sample, 0
        mean_distance fine_row_step, 1
        advance_by mean_sampled, mean_samples, fine_word
        IX      mean_list, 64
        IBXNE   mean_left, m_index_minus_one, r0, fine_mean, mean_left
        BIM     0, link

; ---- The picture -------------------------------------------------------------

        .share  local
        .regs   r43, show_refined, show_first, show_picture, show_planes_left
        .regs   r47, show_row_end, show_mean, show_place
        .endshare

fine_end:
        begin_picture
show_plane:
        of_plane fine_plane, FINE_REFINED, show_refined
        RTOR    fine_row_step, show_place
show_row:
        ADDX    show_place, fine_row_step, show_row_end
        IX      show_place, 64
show_pixel:
        ADDX    show_first, show_place, fine_at
        ES      fine_there, FRAME_CHANNELS - 3
        IBXLE   show_planes_left, r0, fine_there, show_word
        ADDX    show_refined, show_place, fine_there
        LOD     [fine_there], fine_word
        IBXEQ   fine_word, r0, r0, show_word
        ADDX    show_mean, show_place, fine_at
show_word:
        LOD     [fine_at], fine_word
        STO     [show_picture], fine_word
        IX      show_picture, 64
        IX      show_place, 64
        IBXNE   show_place, r0, show_row_end, show_pixel
        IBXNE   show_place, r0, fine_stride, show_row
        ADDX    show_first, fine_stride, show_first
        ADDX    show_mean, fine_stride, show_mean
        IBXNE   show_planes_left, m_index_minus_one, r0, show_plane, show_planes_left
        BIM     0, link
        .endkernel
