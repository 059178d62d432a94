; resolve_1984.s - adds the colours of a level's rays to their parents in the
; previous level, ray by ray.  The reflected ray of a parent precedes its
; refracted ray in the list.
;
; In, out: as for resolve_vector.s.

        .share  loop
        .regs   r156, child_level, parents_at, children_at, parent_index
        .regs   r160, parent_stride, own_color, child_factor, child_color
        .regs   r164, factor0_at, factor1_at, factor2_at
        .regs   r167, color0_at, color1_at, color2_at
        .endshare

        .macro  add_channel factor_at, color_at
        LOD     [\factor_at, loop_index], child_factor
        LOD     [\color_at, loop_index], child_color
        LOD     [parent_index], own_color
        MPYS    child_factor, child_color, child_color
        ADDN    own_color, child_color, own_color
        store_step own_color, parent_index, parent_stride
        .endm

        .kernel resolve
add_children:
        pass_operands level
        to_scalar
        load_words operands, 1, child_level
        LOD     [child_level], loop_count
        ES      loop_index, 0
        list_vector child_level, LIST_PARENT, children_at
        list_vector child_level, LIST_WEIGHT, factor0_at
        list_vector child_level, LIST_WEIGHT + 1, factor1_at
        list_vector child_level, LIST_WEIGHT + 2, factor2_at
        list_vector child_level, LIST_COLOR, color0_at
        list_vector child_level, LIST_COLOR + 1, color1_at
        list_vector child_level, LIST_COLOR + 2, color2_at
        EX      loop_work, 64 * LEVEL_SIZE
        SUBX    color0_at, loop_work, parents_at
        EX      parent_stride, 64 * LIST
        SUBX    child_level, loop_work, child_level
        load_words scene_levels, 1, loop_at
        IBXNE   child_level, r0, loop_at, resolve_child
        load_words scene_frame, 1, parents_at
        load_words scene_pixels, 1, parent_stride
        SHIFTI  parent_stride, 6, parent_stride
resolve_child:
        LOD     [children_at, loop_index], parent_index
        SHIFTI  parent_index, 6, parent_index
        ADDX    parents_at, parent_index, parent_index
        add_channel factor0_at, color0_at
        add_channel factor1_at, color1_at
        add_channel factor2_at, color2_at
        loop_next resolve_child
        to_vector
        BIM     0, link_queue
        .endkernel
