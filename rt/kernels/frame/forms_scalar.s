; forms_scalar.s - kernels of the frame that are written once, in the scalar
; form: their registers, and the macros that differ from those of
; forms_vector.s.

        .macro  unit_vector x, y, z, length, work
        normalise_by m_one, \x, \y, \z, \length, \work
        .endm

; generate.s
        .share  local
        .regs   r32, g_pixel, g_view, g_ray, g_column, g_row
        .regs   r37, g_ox, g_oy, g_oz, g_dx, g_dy, g_dz, g_t, g_u
        .regs   r45, g_lx, g_ly, g_lz, g_basex, g_basey, g_basez, g_colx
        .regs   r52, g_coly, g_colz, g_rowx, g_rowy, g_rowz, g_focus
        .endshare
        .equ    GENERATE_REGISTERS, 25 + 5 * LENS

        .data
generate_save:  .space GENERATE_REGISTERS
        .code

        .macro  begin_rays
generate_ray:
        store_words r32, GENERATE_REGISTERS, generate_save, save_at
        load_from arguments, 3, g_pixel
        SWAP    [g_pixel], g_column, [r0]
        SWAP    [g_view], g_lx, [r0]
        .endm

; x, y, z = base + column per_column + row per_row.
        .macro  aim x, y, z
        three_by MPYS, g_column, g_colx, g_coly, g_colz, \x, \y, \z
        three_by MPYS, g_row, g_rowx, g_rowy, g_rowz, g_t, g_u, third
        three   ADDN, \x, \y, \z, g_basex, g_basey, g_basez, \x, \y, \z
        three   ADDN, g_t, g_u, third, \x, \y, \z, \x, \y, \z
        .endm
        .macro  end_rays
        .if     ! ORIGINS_DIFFER
        copy_three g_lx, g_ly, g_lz, g_ox, g_oy, g_oz
        .endif
        SWAP    [r0], g_ox, [g_ray]
        leave   generate_save, GENERATE_REGISTERS
        .endm

; lens.s
        .share  local
        .regs   r58, g_across, g_table, g_place, g_plane
        .endshare

; places.s
        .share  local
        .regs   r32, place_step, place_first, place_squared, place_row, place_whole
        .regs   r37, place_rest, place_list, place_width, place_sample
        .regs   r41, place_column, place_down
        .endshare

; average.s
        .share  local
        .regs   r32, samples, sample_plane, plane_end, sample_row, sample_at
        .regs   r37, row_stride, pixel_at, framebuffer_left, picture_columns
        .regs   r41, pixels_left, grid_rows, grid_row, grid_left, grid_at
        .regs   r46, share, middle, average_at, average_t, sum
        .regs   r51, sample_step, colours_end
        .reg    pixels, sum
        .endshare
        .macro  begin_average
        SHIFTI  samples, 6, sample_step
        ES      colours_end, FRAME_CHANNELS - 3
        .endm
        .macro  begin_pixels
        .endm
        .macro  fetch_samples at, c
        LOD     [\at], \c
        .endm
        .macro  next_pixels again
        STO     [pixel_at], pixels
        IX      pixel_at, 64
        ADDX    sample_at, sample_step, sample_at
        IBXNE   pixels_left, m_index_minus_one, r0, \again, pixels_left
        .endm
        .macro  end_average
        BIM     0, link
        .endm
