; seen_1984.s - stores the visible crossings of a queue's lines, line by line.
;
; Each crossing of a region is inserted into the planes of its line, after those
; that are not farther.
;
; simple_met is not used, because regions of lines are never simple
; (rt/layout/query_layout.c).
; Source: insertion: Knuth, The Art of Computer Programming 3, 5.2.1.

        .include "frame/trees_1984.s"

; Operands from queue_vector.s.
        .share  loop
        .regs   r236, to_stride, to_step, to_left, to_from, to_first, to_counts, to_start
        .equ    SEEN_OPERANDS, 7

        .regs   r208, c_count, c_slot, c_before, c_plane, c_other, c_least, c_line
        .regs   r215, c_distance, c_primitive, c_sense, c_s, c_t, c_nx, c_ny, c_nz
        .regs   r223, c_other_distance, c_other_primitive
        .endshare

        .data
seen_operands:  .space SEEN_OPERANDS
line_ray:       .space 6
        .code

        .macro  take_seen_operands
        load_at seen_operands, SEEN_OPERANDS, to_stride
        .endm

; Stores the line for the normals.
        .macro  load_line
        load_ray
        EX      loop_at, line_ray
        ELEN    loop_at, 6
        SWAP    [r0], w_ox, [loop_at]
        .endm

; Sets c_line to the address of the line's first crossing.
        .macro  find_line
        ES      c_line, 64
        MPYX    loop_place, c_line, c_line
        ADDX    c_line, to_first, c_line
        .endm

; Moves one word from the previous slot to this slot.
        .macro  move_word
        LOD     [c_before], c_other
        STO     [c_plane], c_other
        ADDX    c_before, to_stride, c_before
        ADDX    c_plane, to_stride, c_plane
        .endm

        .macro  store_word register
        STO     [c_plane], \register
        ADDX    c_plane, to_stride, c_plane
        .endm

; Inserts crossing number c_count of the line.
        .macro  put_in_order
        MPYX    c_count, to_step, c_slot
        ADDX    c_slot, c_line, c_slot
put_next\@:
        IBXEQ   c_count, r0, r0, put_here\@
        SUBX    c_slot, to_step, c_before
        LOD     [c_before], c_other_distance
        ADDX    c_before, to_stride, c_plane
        LOD     [c_plane], c_other_primitive
        CFPLT   c_other_distance, c_distance, put_here\@
        CFPNE   c_other_distance, c_distance, put_move\@
        IBXLT   c_other_primitive, r0, c_primitive, put_here\@
put_move\@:
        RTOR    c_slot, c_plane
        RTOR    c_before, c_slot
        .rept   SEEN_FOUND
        move_word
        .endr
        ADDX    c_count, m_index_minus_one, c_count
        BIM     put_next\@
put_here\@:
        RTOR    c_slot, c_plane
        store_word c_distance
        store_word c_primitive
        store_word c_sense
        store_word c_s
        store_word c_t
        .if     NORMALS
        store_word c_nx
        store_word c_ny
        store_word c_nz
        .endif
        .endm

        .kernel visible
simple_met:
        BIM     walk_skip

walk_tree:
        hand_over line_stride, SEEN_OPERANDS, 0, seen_operands
        walk_rays take_seen_operands
        find_line
        .if     NORMALS
        load_line
        .endif
tree_seen:
        RTOR    w_in, c_distance
        RTOR    w_out, w_leaf
        RTOR    w_out, w_at
        IX      w_at, 64 * P_ID
        LOD     [w_at], c_primitive
        find_sense
        load_at k_delta, 1, c_least
        ADDN    w_in, c_least, c_least          ; within delta: the same place
        RTOR    r0, segment_in
        RTOR    r0, segment_out
        find_point tree_noted
        .if     NORMALS
        RTOR    w_leaf, w_at
        IX      w_at, 64 * P_PATCH_POINT
        STO     [w_at], segment_in
        STO     [w_at, m_index_one], segment_out
        .endif
tree_noted:
        RTOR    segment_in, c_s
        RTOR    segment_out, c_t
        .if     NORMALS
        EX      loop_at, line_ray
        find_normal_there loop_at
        .endif
        CFPEQ   to_start, r0, tree_from_origin
        SUBN    c_distance, to_start, c_distance
tree_from_origin:
        LOD     [to_counts, loop_place], c_count
        ADDX    c_count, m_index_one, c_other
        STO     [to_counts, loop_place], c_other
        put_in_order
        next_visible c_least, tree_skip
        BIM     tree_seen
        rays_end
        .endkernel
