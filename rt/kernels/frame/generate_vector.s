; generate_vector.s - generates the queue's rays.
;
; Pixel k of the frame is in row floor(k / width) and column k - width row. Its
; ray is base + column per_column + row per_row (camera.s), normalised. The
; division k / width truncates towards zero, so its floor is the row for every
; k. Perspective rays start at one point, which stays in aox aoy aoz.
; Orthographic rays have one direction and start at the computed points. Rays
; through a lens have many origins (lens.s).
;
; Queues of tiles: order_vector.s.
;
; In:  position (the first k, relative to the band's first pixel), n; view.
; Out: adx ady adz; if ORIGINS_DIFFER also aox aoy aoz.
; Source: camera.s for the formula. Vectors of any length are derived here.

        .share  scratch
        .regs   r233, basex, basey, basez, colx, coly, colz, rowx, rowy, rowz
        .regs   r242, width, first_pixel
        .endshare

        .if     LENS
        .share  scratch
        .regs   r244, g_across, g_table, g_focus, g_lx, g_ly, g_lz
        .endshare
        .reg    g_column, w0
        .reg    g_row, w1
        .reg    g_place, w2
        .reg    g_t, w3
        .reg    g_ox, aox
        .reg    g_oy, aoy
        .reg    g_oz, aoz
        .reg    g_dx, adx
        .reg    g_dy, ady
        .reg    g_dz, adz
        .reg    g_plane, s1
        .endif

        .if     ADAPTIVE
        .share  scratch
        .regs   r244, place_step, place_first, place_squared, place_row
        .endshare
        .reg    place_list, s0
        .reg    place_whole, w4
        .reg    place_sample, w2
        .reg    place_rest, w3
        .include "frame/places.s"
        .endif

        .macro  direction base, col, row, d
        LINKV
        MPYSV   [w0], \col, [w2]
        ADDNV   [w2], \base, [w2]
        LINKV
        MPYSV   [w1], \row, [w3]
        ADDNV   [w3], [w2], [\d]
        .endm

        .kernel generate
generate:
        set_near n
        EX      s0, view + 64 * VIEW_BASE
        ELEN    s0, VIEW_SIZE - VIEW_BASE
        SWAP    [s0], basex, [r0]
        .if     ADAPTIVE
        load_word scene_wide, width
        load_word fine_list, s0
        IBXNE   s0, r0, r0, generate_samples
        .else
        load_word scene_width, width
        .endif
        load_word queue_order, s0
        IBXNE   s0, r0, r0, generate_tile
        load_word scene_first_pixel, first_pixel
        ADDX    first_pixel, position, first_pixel
        INTVLV  first_pixel, one_index, [w0]
        ADDNV   [w0], r0, [w0]
        LINKV
        DIVSV   [w0], width, [w1]
        FLRV    [w1], [w1]
        ADDNV   [w1], r0, [w1]
        MPYSV   [w1], width, [w2]
        SUBNV   [w0], [w2], [w0]
generate_directions:
        .if     ADAPTIVE
        load_place_steps
        through_middle w0, w0
        through_middle w1, w1
generate_aimed:
        .endif
        .if     ORTHOGRAPHIC
        direction basex, colx, rowx, aox
        direction basey, coly, rowy, aoy
        direction basez, colz, rowz, aoz
        EX      s0, view + 64 * VIEW_LOCATION
        ELEN    s0, 3
        SWAP    [s0], basex, [r0]
        VTOV    basex, [adx]
        VTOV    basey, [ady]
        VTOV    basez, [adz]
        .else
        direction basex, colx, rowx, adx
        direction basey, coly, rowy, ady
        direction basez, colz, rowz, adz
        .endif
        .if     LENS
        load_word view + 64 * VIEW_FOCUS, g_focus
        .if     1 - ORTHOGRAPHIC
        EX      s0, view + 64 * VIEW_LOCATION
        ELEN    s0, 3
        SWAP    [s0], g_lx, [r0]
        .endif
        lens_rays
        .endif
        .if     LENS || ! ORTHOGRAPHIC
        normalise adx, ady, adz, w2, w3
        .endif
        BIM     0, link_kernel

generate_tile:
        EX      target, tile_queue
        BSAVE   link_inner, [target]
        BIM     generate_directions
        .if     ADAPTIVE
generate_samples:
        load_place_steps
        INTVLV  position, one_index, [w0]
        ADDNV   [w0], r0, [w0]
        through_sample w0, width, w0, w1
        BIM     generate_aimed
        .endif
        .endkernel
