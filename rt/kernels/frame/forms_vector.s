; forms_vector.s - kernels of the frame that are written once, in the vector
; form: their registers, which have the names of the scalar form, and the macros
; that differ from those of forms_scalar.s.

        .macro  unit_vector x, y, z, length, work
        normalise \x, \y, \z, \length, \work
        .endm

; generate.s
        .share  scratch
        .if     ORIGINS_DIFFER
        .regs   r233, g_lx, g_ly, g_lz, g_basex, g_basey, g_basez, g_colx
        .regs   r240, g_coly, g_colz, g_rowx, g_rowy, g_rowz, g_focus
        .else
        .regs   r233, g_basex, g_basey, g_basez, g_colx, g_coly, g_colz
        .regs   r239, g_rowx, g_rowy, g_rowz
        .endif
        .regs   w0, g_column, g_row, g_u, g_t
        .regs   aox, g_ox, g_oy, g_oz, g_dx, g_dy, g_dz
        .endshare
        .share  scratch
        .reg    width, r242
        .endshare

; [c] = the numbers of the queue's rays, from the integer `first` on.
        .macro  number_rays first, c
        INTVLV  \first, one_index, [\c]
        ADDNV   [\c], r0, [\c]
        .endm
        .macro  load_view from, first
        load_words view + 64 * \from, VIEW_SIZE - \from, \first, s0
        .endm

; Computes the positions of the queue's rays and loads the view. With many
; origins, the view shares registers with order_vector.s and places.s.
        .macro  begin_rays
generate:
        set_near n
        .if     ! ORIGINS_DIFFER
        load_view VIEW_BASE, g_basex
        .endif
        .if     ADAPTIVE
        load_word scene_wide, width
        load_word fine_list, s0
        IBXNE   s0, r0, r0, generate_samples
        .else
        load_word scene_width, width
        .endif
        load_word queue_order, s0
        IBXNE   s0, r0, r0, generate_tile
        load_word scene_first_pixel, s0
        ADDX    s0, position, s0
        number_rays s0, g_column
        over_floor_normal g_column, width, g_row
        scale   g_row, width, g_u
        minus   g_column, g_u, g_column
generate_directions:
        .if     ADAPTIVE
        load_place_steps
        through_middle g_column, g_column
        through_middle g_row, g_row
generate_aimed:
        .endif
        .if     ORIGINS_DIFFER
        load_view VIEW_LOCATION, g_lx
        .endif
        .endm
        .macro  aim_along base, col, row, x
        line    g_column, \col, \base, g_u
        scaled_plus g_row, \row, g_u, \x
        .endm
        .macro  aim x, y, z
        aim_along g_basex, g_colx, g_rowx, \x
        aim_along g_basey, g_coly, g_rowy, \y
        aim_along g_basez, g_colz, g_rowz, \z
        .endm
        .macro  end_rays
        BIM     0, link_kernel
generate_tile:
        call_routine tile_queue, link_inner
        BIM     generate_directions
        .if     ADAPTIVE
generate_samples:
        load_place_steps
        number_rays position, g_column
        through_sample g_column, width, g_column, g_row
        BIM     generate_aimed
        .endif
        .endm

; lens.s
        .share  scratch
        .regs   r246, g_across, g_table
        .reg    g_place, g_u
        .reg    g_plane, s1
        .endshare

; places.s
        .share  scratch
        .regs   r244, place_step, place_first, place_squared, place_row
        .regs   w2, place_sample, place_rest, place_whole
        .reg    place_list, s0
        .endshare

; average.s
        .share  scratch
        .regs   r233, samples, sample_plane, plane_end, sample_row, sample_at
        .regs   r238, row_stride, pixel_at, pixels, framebuffer_left, picture_columns
        .regs   r243, pixels_left, grid_rows, grid_row, grid_left, grid_at
        .regs   r248, share, middle
        .reg    average_at, s2
        .reg    average_t, s3
        .reg    colours_end, s2
        .reg    sum, red
        .endshare
        .macro  begin_average
        RTOR    link, link_levels
        ES      h, 0
        .endm

; The next h pixels of the row, at most QUEUE.
        .macro  begin_pixels
        at_most QUEUE, pixels_left, s2
        IBXEQ   s2, r0, h, average_some
        RTOR    s2, h
        call_routine set_hits, link_inner
        INTVLV  r0, samples, [at]
average_some:
        ADDLEN  pixel_at, h, pixels
        ES      colours_end, FRAME_CHANNELS - 3
        .endm
        .macro  fetch_samples from, c
        VXTOV   [at], [\from], [\c]
        .endm
        .macro  next_pixels again
        SHIFTI  h, 6, s2
        ADDX    pixel_at, s2, pixel_at
        MPYX    s2, samples, s2
        ADDX    sample_at, s2, sample_at
        SUBX    pixels_left, h, pixels_left
        IBXNE   pixels_left, r0, r0, \again
        .endm
        .macro  end_average
        RTOR    link_levels, link
        BIM     0, link
        .endm
