; places_vector.s - positions of rays in the frame, in units of samples.
;
; See adaptive.s for the units.
;
; through_middles: In: w0, w1 = columns and rows of the first rays.
;                  Out: w0, w1 = columns and rows of samples.
; through_samples: In: position, n; width.  Out: w0, w1.
;
; Let p = floor(k / samples^2). Ray k belongs to sample s = k - samples^2 p of
; the pixel at entry p of fine_list. Sample s is in row floor(s / samples).

        .share  scratch
        .regs   r244, place_step, place_first, place_squared, place_row
        .endshare

        .macro  load_place_steps
        load_word scene_samples, s0
        ADDN    s0, r0, place_step
        first_places one, half, place_step, place_first
        .endm

        .macro  through_middles
        load_place_steps
        LINKV
        MPYSV   [w0], place_step, [w0]
        ADDNV   [w0], place_first, [w0]
        LINKV
        MPYSV   [w1], place_step, [w1]
        ADDNV   [w1], place_first, [w1]
        .endm

; [whole] = floor([numbers] / by), [rest] = the remainder. Writes whole first.
        .macro  divide_places numbers, by, whole, rest
        LINKV
        DIVSV   [\numbers], \by, [\whole]
        FLRV    [\whole], [\whole]
        ADDNV   [\whole], r0, [\whole]
        LINKV
        MPYSV   [\whole], \by, [\rest]
        SUBNV   [\numbers], [\rest], [\rest]
        .endm

        .macro  through_samples
        load_place_steps
        MPYS    place_step, place_step, place_squared
        INTVLV  position, one_index, [w0]
        ADDNV   [w0], r0, [w0]
        divide_places w0, place_squared, w1, w2
        FLRV    [w1], [w1]
        load_word fine_list, s0
        VXTOV   [w1], [s0], [w0]
        ADDNV   [w0], r0, [w0]
        divide_places w0, width, w1, w3
        load_word scene_band, place_row
        ADDNV   [w1], place_row, [w1]
        divide_places w2, place_step, w4, w0
        LINKV
        MPYSV   [w3], place_step, [w3]
        ADDNV   [w3], [w0], [w0]
        LINKV
        MPYSV   [w1], place_step, [w1]
        ADDNV   [w1], [w4], [w1]
        SUBNV   [w0], place_step, [w0]
        SUBNV   [w1], place_step, [w1]
        .endm
