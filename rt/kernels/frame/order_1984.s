; order_1984.s - the pixels of a queue by tiles (order.s), one by one.
;
; These macros are parts of the loop that generates rays: first tiles_begin,
; then tile_pixel for each ray, then tiles_end.

        .share  loop
        .regs   r163, column, row, width
        .regs   r166, strip_number, strip_row, strip_height, strip_at, strips
        .regs   r171, band_row, band_rows, columns
        .regs   r174, tile_row, tile_end, tile_place, tile_places
        .endshare

; Sets tile_row and tile_end to the strip's first row in the frame and the row
; after its last, as numbers.
        .macro  strip_rows
        ADDN    strip_row, r0, tile_row
        ADDN    strip_height, r0, tile_end
        ADDN    tile_row, band_row, tile_row
        ADDN    tile_row, tile_end, tile_end
        .endm

; Computes the first pixel: its column, its row, its position in the planes.
        .macro  tiles_begin
        load_words strip_state, 5, strip_number
        load_words scene_band, 2, band_row
        SUBN    band_rows, band_row, band_rows
        IBXNE   strip_number, r0, r0, tiles_strip
        next_strip band_rows, strips, loop_work
tiles_strip:
        store_word strip_row, strips_done
        strip_rows
        FLR     width, columns
        ADDN    strip_at, r0, column
        ADDN    strip_height, r0, loop_work
        ADDN    column, r0, row
        over_floor_normal column, loop_work, column
        minus_scaled row, column, loop_work, row
        FLR     row, tile_place
        FLR     column, loop_work
        ADDN    row, tile_row, row
        ADDX    tile_place, strip_row, tile_place
        MPYX    tile_place, columns, tile_place
        ADDX    tile_place, loop_work, tile_place
        .endm

; Stores the position of this ray's pixel and advances to the next pixel.
        .macro  tile_pixel next
        STO     [tile_places, loop_index], tile_place
        IX      strip_at, 1
        ADDX    tile_place, columns, tile_place
        ADDN    row, m_one, row
        CFPLT   row, tile_end, \next
        RTOR    tile_row, row
        ADDN    column, m_one, column
        MPYX    strip_height, columns, loop_work
        SUBX    tile_place, loop_work, tile_place
        IX      tile_place, 1
        CFPLT   column, width, \next
        next_strip band_rows, strips, loop_work
        strip_rows
        RTOR    m_zero, column
        RTOR    tile_row, row
        MPYX    strip_row, columns, tile_place
        .endm

        .macro  tiles_end
        store_words strip_number, 4, strip_state
        .endm
