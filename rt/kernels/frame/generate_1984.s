; generate_1984.s - generates the queue's rays one after another.
;
; In, out: as in generate.s.

        .share  loop
        .regs   r156, first_pixel, to_dx, to_dy, to_dz
        .regs   r160, result_dx, result_dy, result_dz
        .if     ORIGINS_DIFFER
        .regs   r178, to_ox, to_oy, to_oz, result_ox, result_oy, result_oz
        .endif
        .endshare

        .if     ADAPTIVE
        .include "frame/places.s"
        .endif

        .data
pixel:          .space 2
result_ray:     .space 6
generate_list:  .descriptor 2, pixel
                .descriptor VIEW_SIZE, view
                .descriptor 6, result_ray
        .code

        .kernel generate
generate:
        load_word scene_first_pixel, s1
        ADDX    s1, position, s1
        pass_operands s1
        pass_operands adx, 3, 1
        .if     ORIGINS_DIFFER
        pass_operands aox, 3, 4
        .endif
        to_scalar
        load_words operands, 4, first_pixel
        .if     ORIGINS_DIFFER
        load_words operands + 64 * 4, 3, to_ox
        .endif
        RTOR    n, loop_count
        ES      loop_index, 0
        .if     ADAPTIVE
        load_words scene_wide, 1, width
        load_place_steps
        .else
        load_word scene_width, width
        .endif
        load_words queue_order, 1, tile_places
        IBXNE   tile_places, r0, r0, generate_tiles
        ADDN    first_pixel, r0, column
        over_floor_normal column, width, row
        minus_scaled column, row, width, column
generate_next:
        EX      loop_at, pixel
        .if     ADAPTIVE
        load_words fine_list, 1, place_list
        IBXNE   place_list, r0, r0, generate_sample
        through_middle column, place_column
        through_middle row, place_down
generate_aimed:
        STO     [loop_at], place_column
        STO     [loop_at, m_index_one], place_down
        .else
        STO     [loop_at], column
        STO     [loop_at, m_index_one], row
        .endif
        call    generate_ray, generate_list
        load_words result_ray + 64 * 3, 3, result_dx
        store_three to_dx, to_dy, to_dz, loop_index, result_dx, result_dy, result_dz
        .if     ORIGINS_DIFFER
        load_words result_ray, 3, result_ox
        store_three to_ox, to_oy, to_oz, loop_index, result_ox, result_oy, result_oz
        .endif
        IBXNE   tile_places, r0, r0, generate_next_of_tile
        ADDN    column, m_one, column
        CFPLT   column, width, generate_same_row
        RTOR    m_zero, column
        ADDN    row, m_one, row
generate_same_row:
        loop_next generate_next
        IBXEQ   tile_places, r0, r0, generate_stored
        tiles_end
generate_stored:
        to_vector
        BIM     0, link_kernel

generate_tiles:
        tiles_begin
        BIM     generate_next
generate_next_of_tile:
        tile_pixel generate_same_row
        BIM     generate_same_row
        .if     ADAPTIVE
generate_sample:
        ADDX    first_pixel, loop_index, loop_work
        load_place_steps
        ADDN    loop_work, r0, place_rest
        through_sample place_rest, width, place_column, place_down
        BIM     generate_aimed
        .endif
        .endkernel
