; bump_scalar.s - computes normals with bumps at a point.  The formulas are in
; bump.s, the order of the operations is that of bump_vector.s.  These macros
; and routines are a part of the subroutines that shade.

        .share  local
        .regs   r126, bump_outer, bump_link
        .regs   r128, raw_x, raw_y, raw_z       ; the normal without bumps
        .reg    bump_at, r131
        .regs   r132, bump_value, bump_x, bump_y, bump_z
        .regs   r136, bump_corner, bump_left
        .reg    height_link, r83                ; shares the register of facing
        .regs   r139, bump_sum_x, bump_sum_y, bump_sum_z
        .regs   r142, bump_share
        .regs   r143, bump_from, bump_to, bump_low, bump_rise
        .endshare

        .macro  bump_words offset, number, first
        RTOR    bump_at, here
        IX      here, 64 * (\offset)
        ELEN    here, \number
        SWAP    [here], \first, [r0]
        .endm

        .macro  bump_word offset, register
        RTOR    bump_at, here
        IX      here, 64 * (\offset)
        LOD     [here], \register
        .endm

; Computes the three products with the nine words that bump_words loaded from
; sh0 on.
        .macro  bump_rows x0, x1, x2, y0, y1, y2
        dot     \x0, \x1, \x2, sh0, sh1, sh2, \y0, t0
        dot     \x0, \x1, \x2, sh3, sh4, sh5, \y1, t0
        dot     \x0, \x1, \x2, sh6, sh7, sh8, \y2, t0
        .endm

        .macro  bump_place x, y, z
        bump_words BUMP_TO_LOCAL, 12, sh0
        local_point sh0, sh1, sh2, sh3, \x
        local_point sh4, sh5, sh6, sh7, \y
        local_point sh8, sh9, sh10, sh11, \z
        .endm

        .macro  bump_push normal, by
        MPYS    y_0, \by, t1
        ADDN    t1, \normal, \normal
        .endm

; v = the position of q in its unit cube, relative to its centre.
        .macro  quilt_place q, v
        RTOR    \q, \v
        less_floor \v, t0
        SUBN    \v, m_half, \v
        .endm

        .macro  quilt_push v, normal
        MPYS    t1, \v, t2
        ADDN    t2, \normal, \normal
        .endm

        .macro  bump_lower share, x, sum
        MPYS    \x, \share, \sum
        .endm

        .macro  bump_upper share, x, sum
        MPYS    \x, \share, t1
        ADDN    \sum, t1, \sum
        .endm

        .macro  call_bump
        EX      target, find_bump
        BSAVE   bump_link, [target]
        .endm

; Applies the primitive's bumps to nx, ny, nz and facing; raw_x .. = the old
; normal.
        .macro  change_normal
        RTOR    nx, raw_x
        RTOR    ny, raw_y
        RTOR    nz, raw_z
        get_field P_BUMP, bump_at
        IBXEQ   bump_at, r0, r0, bumped\@
        bump_word BUMP_ENTRY_COUNT, bump_left
        IBXNE   bump_left, r0, r0, bumped_by_map\@
        call_bump
bumped_found\@:
        RTOR    lx, nx
        RTOR    ly, ny
        RTOR    lz, nz
        dot     nx, ny, nz, dx, dy, dz, facing, t0
        BIM     bumped\@

bumped_by_map\@:
        RTOR    bump_at, bump_outer
        bump_words BUMP_MAP, MAP_SIZE, map_function
        IBXEQ   map_function, r0, r0, bumped_by_all\@
        bump_place q_x, q_y, q_z
        EX      target, find_height
        BSAVE   height_link, [target]
        RTOR    y_0, bump_value
        bump_word BUMP_ENTRIES, bump_at
bumped_seek\@:
        bump_word BUMP_SIZE + BUMP_TO, t1
        CFPLT   bump_value, t1, bumped_between\@
        IX      bump_at, 64 * BUMP_SIZE
        BIM     bumped_seek\@
bumped_between\@:
        bump_words BUMP_FROM, 4, bump_from
        SUBN    bump_value, bump_low, bump_share
        MPYS    bump_share, bump_rise, bump_share
        CFPGE   bump_share, r0, bumped_above\@
        RTOR    m_zero, bump_share
bumped_above\@:
        CFPGE   m_one, bump_share, bumped_below\@
        RTOR    m_one, bump_share
bumped_below\@:
        call_bump
        SUBN    m_one, bump_share, t0
        bump_lower t0, lx, bump_sum_x
        bump_lower t0, ly, bump_sum_y
        bump_lower t0, lz, bump_sum_z
        IX      bump_at, 64 * BUMP_SIZE
        call_bump
        bump_upper bump_share, lx, bump_sum_x
        bump_upper bump_share, ly, bump_sum_y
        bump_upper bump_share, lz, bump_sum_z
bumped_summed\@:
        RTOR    bump_outer, bump_at
        bump_words BUMP_BACK, 9, sh0
        bump_rows bump_sum_x, bump_sum_y, bump_sum_z, lx, ly, lz
        normalise_by m_one, lx, ly, lz, t0, t1
        BIM     bumped_found\@

bumped_by_all\@:
        bump_word BUMP_ENTRIES, bump_at
        RTOR    m_zero, bump_sum_x
        RTOR    m_zero, bump_sum_y
        RTOR    m_zero, bump_sum_z
bumped_each\@:
        call_bump
        bump_word BUMP_RISE, t0
        bump_upper t0, lx, bump_sum_x
        bump_upper t0, ly, bump_sum_y
        bump_upper t0, lz, bump_sum_z
        IX      bump_at, 64 * BUMP_SIZE
        IBXNE   bump_left, m_index_minus_one, r0, bumped_each\@, bump_left
        BIM     bumped_summed\@
bumped\@:
        .endm

        .kernel shade
; lx, ly, lz = the normal by the bump in bump_at, in the space of its map.
find_bump:
        bump_place bump_x, bump_y, bump_z
        bump_words BUMP_TRANSFORM, 9, sh0
        bump_rows raw_x, raw_y, raw_z, lx, ly, lz
        bump_word BUMP_SCALED, t1
        IBXEQ   t1, r0, r0, bump_unscaled
        normalise_by m_one, lx, ly, lz, t0, t1
bump_unscaled:
        bump_words BUMP_MAP, MAP_SIZE, map_function
        IBXEQ   map_function, r0, r0, bump_quilted
        RTOR    bump_at, bump_corner
        IX      bump_corner, 64 * BUMP_CORNERS
        ES      t9, 4
bump_next:
        ELEN    bump_corner, BUMP_CORNER_SIZE
        SWAP    [bump_corner], sh0, [r0]
        ADDN    bump_x, sh0, q_x
        ADDN    bump_y, sh1, q_y
        ADDN    bump_z, sh2, q_z
        EX      target, find_height
        BSAVE   height_link, [target]
        bump_push lx, sh3
        bump_push ly, sh4
        bump_push lz, sh5
        IX      bump_corner, 64 * BUMP_CORNER_SIZE
        IBXNE   t9, m_index_minus_one, r0, bump_next, t9
bump_back:
        bump_words BUMP_BACK, 9, sh0
        bump_rows lx, ly, lz, qx, qy, qz
        bump_word BUMP_NORMALISED, t1
        IBXEQ   t1, r0, r0, bump_returned
        normalise_by m_one, qx, qy, qz, t0, t1
bump_returned:
        RTOR    qx, lx
        RTOR    qy, ly
        RTOR    qz, lz
        BIM     0, bump_link

bump_quilted:
        bump_words BUMP_CORNERS, 3, sh0
        quilt_place bump_x, q_x
        quilt_place bump_y, q_y
        quilt_place bump_z, q_z
        dot     q_x, q_y, q_z, q_x, q_y, q_z, t0, t1
        SQRT    t0, t0
        MPYS    t0, sh2, t1
        ADDN    t1, sh1, t1
        MPYS    t1, t0, t1
        ADDN    t1, sh0, t1
        MPYS    t1, t0, t1
        quilt_push q_x, lx
        quilt_push q_y, ly
        quilt_push q_z, lz
        BIM     bump_back

; y_0 = the height at q_x, q_y, q_z, by map_function .. and the bump's map.
find_height:
        EX      target, find_pattern
        BSAVE   pattern_link, [target]
        bump_word BUMP_HEIGHTS, t1
        IBXEQ   t1, r0, r0, height_found
        RTOR    t1, here
height_next:
        IX      here, 64 * HEIGHT_SIZE
        LOD     [here], t1
        CFPGE   y_0, t1, height_next
        IX      here, -64 * HEIGHT_SIZE
        ELEN    here, HEIGHT_SIZE
        SWAP    [here], t1, [r0]
        SUBN    y_0, t1, t1
        MPYS    t1, t2, t1
        MPYS    t1, t6, t0
        ADDN    t0, t5, t0
        MPYS    t0, t1, t0
        ADDN    t0, t4, t0
        MPYS    t0, t1, t0
        ADDN    t0, t3, y_0
height_found:
        BIM     0, height_link
        .endkernel
