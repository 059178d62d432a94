; ray_hits_scalar.s - computes all visible crossings along one ray, in order.
;
;       CALL FIND_RAY_HITS (RAY, ROOM, COUNT)
;
; RAY = O, D, the least distance, and the least distance enlarged, to be scaled
; (8 words). ROOM = RAY_HIT_SIZE words for each crossing (query.s), consecutive,
; for the most crossings of the scene. COUNT = number of crossings (1).
;
; Regions are visited in turn (hierarchy_scalar.s). VISIBLE is called in each
; until it finds no more crossings. Crossings of one region are found in order.
; Each is inserted after the crossings that are not farther.
; Source: insertion: Knuth, The Art of Computer Programming 3, 5.2.1.

        .include "query/crossing_scalar.s"

        .share  local
        .regs   r89, c_count, c_first, c_end, c_at, c_before
        .regs   r94, c_distance, c_primitive, c_crossing, c_s, c_t, c_nx, c_ny, c_nz
        .regs   r102, c_other_distance, c_other_primitive, c_other_rest
        .endshare
        .equ    QUERY_REGISTERS, 78     ; another crossing uses 8, RAY_HIT_WORDS

        .data
query_save:     .space QUERY_REGISTERS
        .code

; Loads the parameters on w_leaf, if it is a patch or a mesh.
        .macro  find_point
        RTOR    r0, c_s
        RTOR    r0, c_t
        store_point point_stored\@
point_stored\@:
        load_of w_leaf, P_ON_PATCH, w_t0
        IBXEQ   w_t0, r0, r0, point_found\@
        load_part w_leaf, P_PATCH_POINT, 2, c_s
point_found\@:
        .endm

; Inserts the crossing among those found so far.
        .macro  put_in_order
        RTOR    c_end, c_at
        IX      c_end, 64 * RAY_HIT_SIZE
        ADDX    c_count, m_index_one, c_count
put_next\@:
        IBXEQ   c_at, r0, c_first, put_here\@
        load_part c_at, -RAY_HIT_SIZE, RAY_HIT_WORDS, c_other_distance, c_before
        CFPLT   c_other_distance, c_distance, put_here\@
        CFPNE   c_other_distance, c_distance, put_move\@
        IBXLT   c_other_primitive, r0, c_primitive, put_here\@
put_move\@:
        store_to c_other_distance, RAY_HIT_WORDS, c_at
        RTOR    c_before, c_at
        BIM     put_next\@
put_here\@:
        store_to c_distance, RAY_HIT_WORDS, c_at
        .endm

        .kernel visible
find_ray_hits:
        enter_walk query_save, QUERY_REGISTERS, 3
        load_word k_far, w_limit
        ES      c_count, 0
        RTOR    w_argument, c_first
        RTOR    c_first, c_end
        IBXEQ   w_regions_left, r0, r0, query_leaf
        .endkernel
        .kernel bound
query_region:
        load_region
        skip_far w_cx, w_cy, w_cz, w_radius, w_square, w_limit, query_skip
        test_box query_tree, query_tree, query_skip
        .endkernel
        .kernel visible
query_tree:
        RTOR    w_limit, w_end
        call_routine intersect_tree, w_back
        IBXEQ   w_hit, r0, r0, query_skip
query_next_region:
        next_visible w_least, query_skip
        find_crossing
        find_point
        .if     NORMALS
        find_normal_at w_ray
        .endif
        load_word query_start, w_t0
        CFPEQ   w_t0, r0, query_from_origin
        SUBN    c_distance, w_t0, c_distance
query_from_origin:
        put_in_order
        load_word k_delta, w_t0         ; within delta: the same place
        ADDN    w_in, w_t0, w_least
        BIM     query_next_region
        .endkernel
        .kernel bound
query_skip:
        next_region query_region
query_leaf:
        next_leaf query_region, query_done
        .endkernel
        .kernel visible
query_done:
        STO     [w_result_at], c_count
        leave_walk query_save, QUERY_REGISTERS
        .endkernel
