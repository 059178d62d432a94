; visible_scalar.s - finds the next visible crossing of a Boolean tree.
;
;       CALL VISIBLE (REGION, CROSSINGS, SPAN, EVENT)
;
; REGION = its record. CROSSINGS = offset of the ray's crossings from the first
; ones. A leaf has, from P_FIRST_STATE on, the distances at which the ray enters
; and leaves each segment, and from P_FIRST_EVENT on its events, the crossings
; that may be visible. They are CROSSING_SIZE words apart. A miss is big,
; minus_big. SPAN = last, limit, address after the last active branch, and the
; first leaf that the ray hits; P_NEXT_HIT chains the other leaves (4 words).
; The value of a missed leaf is 0. EVENT = the least visible distance with last
; < distance < limit, and the record of its primitive; big, 0 if there is none
; (2 words).
;
; visible_vector.s gives the rule of visibility and its source. Both bits of a
; value are in one word: 2 before, 1 after. Events are examined in order until
; one is visible. If only the bits of the event's own leaf differ, it shows.

        .share  local
        .regs   r32, v_region, v_crossings, v_span, v_event
        .regs   r36, v_result, v_branches, v_branch
        .regs   r39, v_next, v_segments, v_events, v_first_state
        .regs   r43, v_first_event, v_place
        .regs   r45, v_last, v_limit, v_branches_end, v_first
        .regs   r49, v_distance, v_leaf
        .regs   r51, v_primitive, v_at, v_left, v_crossing, v_in, v_out
        .regs   r57, v_delta, v_before, v_after, v_value
        .regs   r61, t_operation, t_left, t_right, t_result
        .regs   r65, v_index_two, v_index_three, v_others, v_visible
        .endshare
        .equ    VISIBLE_REGISTERS, 37
        .equ    STRIDE, 64 * CROSSING_SIZE
        .equ    NO_LEAF, 0x7FFFFFFFFFFF ; above every address

        .data
visible_save:   .space VISIBLE_REGISTERS
visible_list:   .descriptor R_SIZE, 0
                .word 0                 ; crossings
                .descriptor 4, span
                .descriptor 2, event_found
span:           .space 4
event_found:    .space 2
        .code

; Loads the next crossing at v_at.
        .macro  next_crossing register
        LOD     [v_at], \register
        IX      v_at, STRIDE
        .endm

        .macro  crossings_from slot
        .if     CROSSING_SIZE == 1
        RTOR    \slot, v_at
        .else
        ADDX    v_crossings, \slot, v_at
        .endif
        .endm

        .macro  load_leaf
        load_part v_primitive, P_NEXT_HIT, 6, v_next, v_at
        .endm

; Loads the address and number of a branch's steps, v_at and v_left.
        .macro  load_steps
        load_from v_branch, BRANCH_SIZE, v_at   ; v_at, v_left
        .endm

; Branches to `other` if the crossing is farther than delta from the event.
        .macro  crossing_near other
        CFPLT   v_crossing, v_before, \other
        CFPLT   v_after, v_crossing, \other
        .endm

; Branches to `same` if the two bits of a value are equal.
        .macro  value_differs value, same
        IBXEQ   \value, r0, r0, \same
        IBXEQ   \value, r0, v_index_three, \same
        .endm

; For the walks through regions (bound_scalar.s): finds the next visible
; crossing of a tree beyond `last` and before w_end. Sets w_in to its distance
; and w_out to its primitive, or branches to `none`.
        .macro  next_visible last, none
        EX      w_at, span
        STO     [w_at], \last
        STO     [w_at, m_index_one], w_end
        store_word w_region, visible_list, w_at
        .if     CROSSING_SIZE != 1
        STO     [w_at, m_index_one], w_crossings
        .endif
        call    visible, visible_list
        load_words event_found, 2, w_in, w_at
        IBXEQ   w_out, r0, r0, \none
        .endm

        .kernel visible
visible:
        store_words r32, VISIBLE_REGISTERS, visible_save, save_at
        load_from arguments, 4, v_region
        SWAP    [v_span], v_last, [r0]
        IX      v_region, 64 * R_RESULT
        LOD     [v_region], v_result
        load_word k_delta, v_delta
        load_word scene_branches, v_branches
        ES      v_index_two, 2
        ES      v_index_three, 3

; Finds the next event.
visible_step:
        RTOR    v_limit, v_distance
        ES      v_leaf, 0
        RTOR    v_first, v_primitive
visible_leaf:
        load_leaf
        crossings_from v_first_event
visible_event:
        next_crossing v_crossing
        CFPGE   v_last, v_crossing, visible_not_this
        CFPGE   v_crossing, v_distance, visible_not_this
        RTOR    v_crossing, v_distance
        RTOR    v_primitive, v_leaf
visible_not_this:
        IBXNE   v_events, m_index_minus_one, r0, visible_event, v_events
        RTOR    v_next, v_primitive
        IBXNE   v_primitive, r0, r0, visible_leaf
        IBXEQ   v_leaf, r0, r0, visible_none

; Computes the values of the leaves before and after it.
        SUBN    v_distance, v_delta, v_before
        ADDN    v_distance, v_delta, v_after
        ES      v_others, 0
        RTOR    v_first, v_primitive
visible_state:
        load_leaf
        ES      v_value, 0
        IBXEQ   v_segments, r0, r0, visible_surface
        crossings_from v_first_state
visible_segment:
        next_crossing v_in
        next_crossing v_out
        CFPLT   v_after, v_in, visible_next_segment
        CFPGE   v_after, v_out, visible_left
        OR      v_value, m_index_one, v_value
visible_left:
        CFPGE   v_in, v_before, visible_next_segment
        CFPLT   v_out, v_before, visible_next_segment
        OR      v_value, v_index_two, v_value
visible_next_segment:
        IBXNE   v_segments, m_index_minus_one, r0, visible_segment, v_segments
visible_store:
        SHIFTI  v_value, -1, v_in
        STO     [v_place], v_value
        XOR     v_in, v_value, v_in
        XOR     v_primitive, v_leaf, v_out
        AND     v_in, m_index_one, v_in
        SUBX    r0, v_in, v_in
        AND     v_in, v_out, v_in
        OR      v_others, v_in, v_others        ; 0: only its own leaf differs
        RTOR    v_next, v_primitive
        IBXNE   v_primitive, r0, r0, visible_state

; Evaluates the tree: each branch after those below it.
        RTOR    v_branches_end, v_branch
        IBXEQ   v_branch, r0, v_branches, visible_decide
visible_branch:
        IX      v_branch, -64 * BRANCH_SIZE
        load_steps
visible_tree:
        load_from v_at, T_SIZE, t_operation
        LOD     [t_left], v_in
        LOD     [t_right], v_out
        IBXEQ   t_operation, r0, m_index_one, visible_or
        IBXEQ   t_operation, r0, r0, visible_and
        XOR     v_out, v_index_three, v_out
visible_and:
        AND     v_in, v_out, v_value
        BIM     visible_stepped
visible_or:
        OR      v_in, v_out, v_value
visible_stepped:
        STO     [t_result], v_value
        IX      v_at, 64 * T_SIZE
        IBXNE   v_left, m_index_minus_one, r0, visible_tree, v_left
        IBXNE   v_branch, r0, v_branches, visible_branch
visible_decide:
        LOD     [v_result], v_value
        value_differs v_value, visible_hidden
        IBXEQ   v_others, r0, r0, visible_found

; Finds the parts that show. If a value stays the same, its parts do not show.
        RTOR    v_branches, v_branch
visible_branch_part:
        load_steps
        ES      v_in, 64 * T_SIZE
        MPYX    v_left, v_in, v_in
        ADDX    v_at, v_in, v_at
visible_part:
        IX      v_at, -64 * T_SIZE
        load_from v_at, T_SIZE, t_operation
        LOD     [t_result], v_value
        value_differs v_value, visible_same
        BIM     visible_next_part
visible_same:
        STO     [t_left], r0
        STO     [t_right], r0
visible_next_part:
        IBXNE   v_left, m_index_minus_one, r0, visible_part, v_left
        IX      v_branch, 64 * BRANCH_SIZE
        IBXNE   v_branch, r0, v_branches_end, visible_branch_part

; Finds the first leaf that shows, and whether one that shows has this event.
        EX      v_leaf, NO_LEAF
        ES      v_visible, 0
        RTOR    v_first, v_primitive
visible_shown:
        load_leaf
        LOD     [v_place], v_value
        value_differs v_value, visible_next_shown
        crossings_from v_first_event
visible_crossing:
        next_crossing v_crossing
        crossing_near visible_next_crossing
        IBXGE   v_primitive, r0, v_leaf, visible_not_least
        RTOR    v_primitive, v_leaf
visible_not_least:
        CFPNE   v_crossing, v_distance, visible_next_crossing
        ES      v_visible, 1
visible_next_crossing:
        IBXNE   v_events, m_index_minus_one, r0, visible_crossing, v_events
visible_next_shown:
        RTOR    v_next, v_primitive
        IBXNE   v_primitive, r0, r0, visible_shown
        IBXNE   v_visible, r0, r0, visible_found
visible_hidden:
        RTOR    v_distance, v_last
        BIM     visible_step
visible_surface:
        crossings_from v_first_event
visible_surface_crossing:
        next_crossing v_crossing
        crossing_near visible_next_surface
        ES      v_value, 1
visible_next_surface:
        IBXNE   v_events, m_index_minus_one, r0, visible_surface_crossing, v_events
        BIM     visible_store
visible_none:
        RTOR    m_big, v_distance
visible_found:
        SWAP    [r0], v_distance, [v_event]
        leave   visible_save, VISIBLE_REGISTERS
        .endkernel
