; places_scalar.s - positions of rays in the frame, as in places_vector.s.

        .share  local
        .regs   r32, place_step, place_first, place_squared, place_row, place_whole
        .regs   r37, place_rest, place_list, place_width, place_sample
        .regs   r41, place_column, place_down
        .endshare

        .macro  load_place_steps
        load_at scene_samples, 1, place_list
        ADDN    place_list, r0, place_step
        first_places m_one, m_half, place_step, place_first
        .endm

        .macro  divide_place number, by, whole, rest
        DIVS    \number, \by, \whole
        FLR     \whole, \whole
        ADDN    \whole, r0, \whole
        MPYS    \whole, \by, \rest
        SUBN    \number, \rest, \rest
        .endm

; Computes the position of the sample ray with the number `at`, an integer.
        .macro  through_sample at, column, row
        load_place_steps
        MPYS    place_step, place_step, place_squared
        ADDN    \at, r0, place_rest
        divide_place place_rest, place_squared, place_whole, place_sample
        FLR     place_whole, place_whole
        load_at fine_list, 1, place_list
        LOD     [place_list, place_whole], place_whole
        ADDN    place_whole, r0, place_whole
        load_at scene_wide, 1, place_width
        divide_place place_whole, place_width, \row, \column
        load_at scene_band, 1, place_row
        ADDN    \row, place_row, \row
        divide_place place_sample, place_step, place_whole, place_rest
        MPYS    \column, place_step, \column
        ADDN    \column, place_rest, \column
        MPYS    \row, place_step, \row
        ADDN    \row, place_whole, \row
        SUBN    \column, place_step, \column
        SUBN    \row, place_step, \row
        .endm

; Computes the position of the first ray of a column or row.
        .macro  through_middle number, position
        MPYS    \number, place_step, \position
        ADDN    \position, place_first, \position
        .endm
