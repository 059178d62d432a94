; order_vector.s - the pixels of a queue by tiles (order.s), in vectors.
;
; blank_planes: sets the band's planes to the background and zeros.  A queue
;               in order of tiles writes only its hits.
; tile_queue:   In: n, w0 .. n long; width.  Out: w0 = columns, w1 = rows of
;               the frame, numbers; order_store = positions in the band's
;               planes, integers.
; Formulas: order.s. The division k / h truncates towards zero, so its floor is
; the column for every k.

        .share  scratch
        .regs   r244, strip_number, strip_row, strip_height, strip_at, strips
        .regs   r249, tile_left, tile_count, columns, band_row, band_rows
        .endshare

; Makes the part of a vector that the current strip fills, starting at `base`.
        .macro  tile_part base, into
        RTOR    \base, \into
        ADDLEN  \into, tile_count, \into
        .endm

        .macro  tile_advance base
        ADDX    \base, s9, \base
        .endm

        .kernel frame
        .macro  blank_words
        call_routine blank, link_inner
        .endm

blank_planes:
        load_word scene_tiles, s0
        IBXEQ   s0, r0, r0, blank_none
        load_words scene_background, 3, s1, s0
        load_word scene_frame, s5
        load_word scene_pixels, s4
        RTOR    s1, s6
        blank_words
        RTOR    s2, s6
        blank_words
        RTOR    s3, s6
        blank_words
        ES      s6, FRAME_CHANNELS - 3
        MPYX    s4, s6, s4
        ADDN    r0, r0, s6              ; not 0, but machine zero
        blank_words
blank_none:
        BIM     0, link

; Sets s4 words from s5 on to s6, and s5 to the address after them.
blank:
        RTOR    s4, s7
blank_next:
        at_most 65535, s7, s8                   ; the longest vector
        ADDLEN  s5, s8, s9
        VTOV    s6, [s9]
        SUBX    s7, s8, s7
        SHIFTI  s8, 6, s8
        ADDX    s5, s8, s5
        IBXNE   s7, r0, r0, blank_next
        BIM     0, link_inner
        .endkernel

        .kernel generate
tile_queue:
        load_words strip_state, 5, strip_number, s0
        load_words scene_band, 2, band_row, s0
        SUBN    band_rows, band_row, band_rows
        FLR     width, columns
        IBXNE   strip_number, r0, r0, tile_begin
        next_strip band_rows, strips, s0
tile_begin:
        store_word strip_row, strips_done, s0
        RTOR    n, tile_left
        copy_three w0, w1, w2, s2, s3, s4
        ELEN    s2, 0
        ELEN    s3, 0
        ELEN    s4, 0
tile_next:
        MPYX    strip_height, columns, s0
        SUBX    s0, strip_at, tile_count
        IBXLE   tile_count, r0, tile_left, tile_some
        RTOR    tile_left, tile_count
tile_some:
        tile_part s2, s5
        tile_part s3, s6
        tile_part s4, s7
        ADDN    strip_height, r0, s8
        INTVLV  strip_at, one_index, [s7]
        ADDNV   [s7], r0, [s7]
        over_floor_normal s7, s8, s5
        scale   s5, s8, s6
        minus   s7, s6, s6
        ADDN    strip_row, r0, s8
        ADDNV   [s6], s8, [s6]
        SHIFTI  tile_count, 6, s9
        tile_advance s2
        tile_advance s3
        tile_advance s4
        SUBX    tile_left, tile_count, tile_left
        ADDX    strip_at, tile_count, strip_at
        MPYX    strip_height, columns, s0
        IBXNE   strip_at, r0, s0, tile_in_strip
        next_strip band_rows, strips, s0
tile_in_strip:
        IBXNE   tile_left, r0, r0, tile_next
        store_words strip_number, 4, strip_state, s0
        describe s0, order_store, n
        LINKV
        MPYSV   [w1], width, [w2]
        ADDNV   [w2], [w0], [w2]
        FLRV    [w2], [s0]
        ADDNV   [w1], band_row, [w1]
        BIM     0, link_inner
        .endkernel
