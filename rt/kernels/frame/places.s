; places.s - computes positions of rays in the frame, in units of samples.
;
; adaptive.s describes the units. forms_scalar.s and forms_vector.s declare
; place_step .. place_rest. A frame of samples^2 times as many pixels has the
; samples at integer positions. In it, the first ray of column or row k is at
; step k + first, with first = -(samples + 1)/2.
;
; Let p = floor(k / samples^2). Ray k belongs to sample s = k - samples^2 p of
; the pixel at entry p of fine_list. Sample s is in row floor(s / samples).

        .macro  load_place_steps
        load_word scene_samples, place_list
        ADDN    place_list, r0, place_step
        ADDN    place_step, m_one, place_first
        MPYS    place_first, m_half, place_first
        SUBN    r0, place_first, place_first
        .endm

; whole = floor(number / by), rest = the remainder. Writes whole first.
        .macro  divide_place number, by, whole, rest
        over_floor_normal \number, \by, \whole
        minus_scaled \number, \whole, \by, \rest
        .endm

; Computes the position of the sample ray with the number k, normalised; width =
; the columns of the first rays. The steps are loaded.
        .macro  through_sample k, width, column, row
        MPYS    place_step, place_step, place_squared
        divide_place \k, place_squared, place_whole, place_sample
        floor   place_whole, place_whole
        load_word fine_list, place_list
        gather  place_whole, place_list, \column
        normal  \column, \column
        divide_place \column, \width, \row, \column
        load_word scene_band, place_row
        raise   \row, place_row, \row
        divide_place place_sample, place_step, place_whole, place_rest
        scaled_plus \column, place_step, place_rest, \column
        scaled_plus \row, place_step, place_whole, \row
        lower   \column, place_step, \column
        lower   \row, place_step, \row
        .endm

; Computes the position of the first ray of a column or row.
        .macro  through_middle number, position
        line    \number, place_step, place_first, \position
        .endm
