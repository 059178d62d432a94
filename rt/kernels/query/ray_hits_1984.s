; ray_hits_1984.s - stores the visible crossings of a queue's rays, ray by ray.
;
; Each crossing of a region is inserted into the planes of its ray, after those
; that are not farther.
;
; simple_hit is not used, because regions of rays are never simple
; (rt/layout/query_layout.c).
; Source: insertion: Knuth, The Art of Computer Programming 3, 5.2.1.

        .include "frame/trees_1984.s"

; Operands from queue_vector.s.
        .share  loop
        .regs   r236, to_stride, to_step, to_left, to_from, to_first, to_counts, to_start
        .equ    QUERY_OPERANDS, 7

        .regs   r208, c_count, c_slot, c_before, c_plane, c_other, c_least, c_first_hit
        .regs   r215, c_distance, c_primitive, c_crossing, c_s, c_t, c_nx, c_ny, c_nz
        .regs   r223, c_other_distance, c_other_primitive
        .endshare

        .data
query_operands: .space QUERY_OPERANDS
query_ray:      .space 6
        .code

        .macro  load_query_operands
        load_words query_operands, QUERY_OPERANDS, to_stride
        .endm

; Stores the ray for the normals.
        .macro  load_query_ray
        load_ray
        store_words w_ox, 6, query_ray
        .endm

; Sets c_first_hit to the address of the ray's first crossing.
        .macro  find_query_hits
        ES      c_first_hit, 64
        MPYX    loop_ray_index, c_first_hit, c_first_hit
        ADDX    c_first_hit, to_first, c_first_hit
        .endm

; Moves one word from the previous slot to this slot.
        .macro  move_word
        LOD     [c_before], c_other
        STO     [c_plane], c_other
        ADDX    c_before, to_stride, c_before
        ADDX    c_plane, to_stride, c_plane
        .endm

; Inserts crossing number c_count of the ray.
        .macro  put_in_order
        MPYX    c_count, to_step, c_slot
        ADDX    c_slot, c_first_hit, c_slot
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
        .rept   RAY_HIT_WORDS
        move_word
        .endr
        ADDX    c_count, m_index_minus_one, c_count
        BIM     put_next\@
put_here\@:
        RTOR    c_slot, c_plane
        store_step c_distance, c_plane, to_stride
        store_step c_primitive, c_plane, to_stride
        store_step c_crossing, c_plane, to_stride
        store_step c_s, c_plane, to_stride
        store_step c_t, c_plane, to_stride
        .if     NORMALS
        store_step c_nx, c_plane, to_stride
        store_step c_ny, c_plane, to_stride
        store_step c_nz, c_plane, to_stride
        .endif
        .endm

        .kernel visible
simple_hit:
        BIM     walk_skip

walk_tree:
        pass_operands query_stride, QUERY_OPERANDS, 0, query_operands
        walk_rays load_query_operands
        find_query_hits
        .if     NORMALS
        load_query_ray
        .endif
tree_visible:
        find_crossing
        load_words k_delta, 1, c_least
        ADDN    w_in, c_least, c_least          ; within delta: the same place
        RTOR    r0, segment_in
        RTOR    r0, segment_out
        find_point tree_stored
        .if     NORMALS
        address_of w_leaf, P_PATCH_POINT, w_at
        STO     [w_at], segment_in
        STO     [w_at, m_index_one], segment_out
        .endif
tree_stored:
        RTOR    segment_in, c_s
        RTOR    segment_out, c_t
        .if     NORMALS
        EX      loop_at, query_ray
        find_normal_at loop_at
        .endif
        CFPEQ   to_start, r0, tree_from_origin
        SUBN    c_distance, to_start, c_distance
tree_from_origin:
        LOD     [to_counts, loop_ray_index], c_count
        ADDX    c_count, m_index_one, c_other
        STO     [to_counts, loop_ray_index], c_other
        put_in_order
        next_visible c_least, tree_skip
        BIM     tree_visible
        rays_end
        .endkernel
