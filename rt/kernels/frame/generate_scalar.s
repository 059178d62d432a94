; generate_scalar.s - generates the ray of one pixel.
;
;       CALL GENERATE_RAY (PIXEL, VIEW, RAY)
;
; PIXEL = column, row (2 words, normalised). VIEW as computed by camera.s.
; RAY = O, D (6 words). Formulas and order of operations: generate_vector.s.

        .share  local
        .regs   r32, g_pixel, g_view, g_ray, g_column, g_row
        .regs   r37, g_ox, g_oy, g_oz, g_dx, g_dy, g_dz, g_t, g_u
        .regs   r45, g_lx, g_ly, g_lz, g_basex, g_basey, g_basez, g_colx
        .regs   r52, g_coly, g_colz, g_rowx, g_rowy, g_rowz, g_focus
        .if     LENS
        .regs   r58, g_across, g_table, g_place, g_plane
        .endif
        .endshare
        .if     ADAPTIVE
        .share  local
        .regs   r32, place_step, place_first, place_squared, place_row, place_whole
        .regs   r37, place_rest, place_list, place_width, place_sample
        .regs   r41, place_column, place_down
        .endshare
        .endif
        .if     LENS
        .equ    GENERATE_REGISTERS, 30
        .else
        .equ    GENERATE_REGISTERS, 25
        .endif

        .data
generate_save:  .space GENERATE_REGISTERS
        .code
        .kernel generate
generate_ray:
        EX      save_at, generate_save
        ELEN    save_at, GENERATE_REGISTERS
        SWAP    [r0], r32, [save_at]
        ELEN    arguments, 3
        SWAP    [arguments], g_pixel, [r0]
        SWAP    [g_pixel], g_column, [r0]
        SWAP    [g_view], g_lx, [r0]
        MPYS    g_column, g_colx, g_dx
        MPYS    g_column, g_coly, g_dy
        MPYS    g_column, g_colz, g_dz
        MPYS    g_row, g_rowx, g_t
        MPYS    g_row, g_rowy, g_u
        MPYS    g_row, g_rowz, third
        ADDN    g_dx, g_basex, g_dx
        ADDN    g_dy, g_basey, g_dy
        ADDN    g_dz, g_basez, g_dz
        ADDN    g_t, g_dx, g_dx
        ADDN    g_u, g_dy, g_dy
        ADDN    third, g_dz, g_dz
        .if     ORTHOGRAPHIC
        RTOR    g_dx, g_ox
        RTOR    g_dy, g_oy
        RTOR    g_dz, g_oz
        RTOR    g_lx, g_dx
        RTOR    g_ly, g_dy
        RTOR    g_lz, g_dz
        .endif
        .if     LENS
        lens_rays
        .endif
        .if     LENS || ! ORTHOGRAPHIC
        dot     g_dx, g_dy, g_dz, g_dx, g_dy, g_dz, g_t, g_u
        SQRT    g_t, g_t
        DIVS    m_one, g_t, g_t
        MPYS    g_dx, g_t, g_dx
        MPYS    g_dy, g_t, g_dy
        MPYS    g_dz, g_t, g_dz
        .endif
        .if     ! ORIGINS_DIFFER
        RTOR    g_lx, g_ox
        RTOR    g_ly, g_oy
        RTOR    g_lz, g_oz
        .endif
        SWAP    [r0], g_ox, [g_ray]
        leave   generate_save, GENERATE_REGISTERS
        .endkernel
