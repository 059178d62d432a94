; visible_vector.s - finds the visible crossings of a region.
;
; The crossings ahead are examined in order, for all current rays at a time:
;
;   E = the least crossing of a primitive with  last < E < limit
;   before(j) = in <  E - delta and not out <  E - delta, for any segment of
;               primitive j
;   after(j)  = in <= E + delta and not out <= E + delta, likewise
;
; A surface without inside is 0 before. It is 1 after if it has a crossing in
; the range E - delta .. E + delta. A primitive shows at E if its value changes
; there, and the value of every solid that it is a part of changes too. A
; crossing E is visible if a primitive shows that has this crossing. The hit is
; on the first primitive in the scene that shows and has a crossing in this
; range.
;
; before and after are bit vectors. Logical instructions on bit strings evaluate
; the tree, 64 rays per clock. Both sides are evaluated at a distance of delta,
; so surfaces that coincide count as one. If only the primitive of E changes, it
; shows. The parts of the tree are examined only for other rays. Rays whose
; crossing is visible are done, and so are rays without a crossing. The others
; continue after E (last = E). When fewer than half of the rays are left, they
; are compressed together with all their crossings.
;
; In:  region, its crossings, the current rays; found: a routine that
;      processes the visible crossings at [event] on the primitives
;      [event_primitive] of the rays of [visible_rays], and leaves in
;      [visible_rays] the rays that are done.
;
; VISIBLE selects the method when the program is assembled. The default was
; chosen by measured clocks (docs/solids.md):
;
;   STEPPING  as above
;   EVERY     each crossing of each primitive (visible_every_vector.s)
;
; Source: the project's notes on ray tracing, 4.1: the before/after rule, event
; stepping. The rule of visibility is derived here.

        .equ    STEPPING, 1
        .equ    EVERY, 2
        option  VISIBLE, STEPPING

        .share  crossings
        .regs   r107, step_at, steps_left, branch_at
        .endshare
        .share  hits
        .reg    column, r143            ; of events
        .endshare

; A step of the tree, in the registers of a primitive's part in it.
        .share  scratch
        .regs   r248, tree_operation, tree_left, tree_right, tree_result
        .endshare

; Values before and after an event.
        .share  hits
        .regs   r136, value, value_after, left, left_after, right, right_after
        .endshare

; Makes the vectors of the events of the current rays.
        .macro  set_events
        describe event, event_store, near
        describe event_primitive, event_store + 64 * QUEUE, near
        describe before, event_store + 64 * QUEUE * 2, near
        describe after, event_store + 64 * QUEUE * 3, near
        describe active, event_bits, near
        describe visible_rays, event_bits + 64 * QUEUE_BIT_WORDS, near
        describe inside, event_bits + 64 * QUEUE_BIT_WORDS * 2, near
        .endm

; [bits] = rays with the crossing [slot] between E - delta and E + delta.
        .macro  crossing_near bits, work
        CMPGEV  [slot], [before], [\bits]
        keep_where CMPGEV, [after], [slot], \bits, \work
        .endm

; Loads an active leaf and its value.
        .macro  leaf_with_value
        load_leaf_record
        value_of leaf_value, value, value_after
        .endm

        .macro  tree_value
        load_of region, R_RESULT, s0
        value_of s0, value, value_after
        .endm

; Loads the range of active branches, from s2 to s3.
        .macro  load_branches
        load_words scene_branches, 2, s2, s0    ; s2, s3
        .endm

; Loads the steps of the current branch.
        .macro  load_steps
        load_from branch_at, BRANCH_SIZE, step_at ; step_at, steps_left
        .endm

; Takes the crossings in [vector] that are after last and nearer than the event,
; and advances to the next slot.
        .macro  nearer_event vector
        CMPLTV  [last], [\vector], [bits0]
        keep_where CMPLTV, [\vector], [event], bits0, bits1
        if_none bits0, s0, event_later\@
        VTOV    [\vector], [event] ? [bits0]
        VTOV    identity, [event_primitive] ? [bits0]
event_later\@:
        ADDX    slot, slot_size, slot
        .endm

        .macro  both_values operation
        \operation [left], [right], [value]
        \operation [left_after], [right_after], [value_after]
        .endm

        .kernel visible
walk_tree:
        load_leaves
        IBXEQ   first_leaf, r0, leaves_last, walk_skip
        set_events
        describe last, last_store, near
        .if     VISIBLE == EVERY
        BIM     walk_every
        .endif

; Finds the next event of each ray.
tree_next:
        VTOV    [near_limit], [event]
        VTOV    r0, [event_primitive]
        leaves_begin
event_leaf:
        load_leaf_record
        load_field P_ID, identity
        find_slot leaf_first_event
        IBXEQ   leaf_segments, r0, r0, event_next
        IBXEQ   leaf_first_state, r0, leaf_first_event, event_segment
event_next:
        nearer_event slot
        IBXNE   leaf_events, minus_one_index, r0, event_next, leaf_events
        BIM     event_none

; Selects the next end of a segment after last.
event_segment:
        next_slot s2
        CMPLTV  [last], [s2], [bits0]
        MASKV   [s2], [slot], [w0] ? [bits0]
        nearer_event w0
        IBXNE   leaf_segments, minus_one_index, r0, event_segment, leaf_segments
event_none:
        leaves_next event_leaf
        CMPNEV  [event_primitive], r0, [active]
        if_none active, s9, walk_skip
        ADDX    s9, s9, s0
        IBXGE   s0, r0, near, tree_values
        CPSV    [event], [event] ? [active]
        CPSV    [event_primitive], [event_primitive] ? [active]
        call_routine compress_rays, link_inner

tree_values:
        RTOR    event, column
        call_routine find_visible, link_inner
        IBXEQ   s0, r0, r0, tree_continue
        BSAVE   link_kernel, [found]
        ANDNB   [active], [visible_rays], [active]
        if_none active, s9, walk_skip
        VTOV    big, [event] ? [visible_rays]
        BIM     tree_left_over
tree_continue:
        CNTOB   [active], s9
tree_left_over:
        describe last, last_store, near
        ADDX    s9, s9, s0
        IBXLT   s0, r0, near, tree_compress
        VTOV    [event], [last]
        BIM     tree_next
tree_compress:
        CPSV    [event], [last] ? [active]
        call_routine compress_rays, link_inner
        BIM     tree_next

; Finds the visible crossings at the events of a column, one for each ray.
;
; In:  column, with its primitives in event_primitive; active.
; Out: visible_rays, a part of active; s0 = the count of its ones;
; event_primitive: the
;      visible primitive; its P_TESTED.
find_visible:
        load_word k_delta, s0
        SUBNV   [column], s0, [before]
        ADDNV   [column], s0, [after]
        leaves_begin
value_leaf:
        leaf_with_value
        XORB    [value], [value], [value]
        XORB    [value_after], [value_after], [value_after]
        IBXEQ   leaf_segments, r0, r0, value_patch
        find_slot leaf_first_state
value_segment:
        CMPLTV  [slot], [before], [bits0]
        CMPGEV  [after], [slot], [bits1]
        ADDX    slot, slot_size, slot
        CMPLTV  [slot], [before], [bits2]
        CMPGEV  [after], [slot], [inside]
        ADDX    slot, slot_size, slot
        ANDNB   [bits0], [bits2], [bits0]
        ANDNB   [bits1], [inside], [bits1]
        ORB     [value], [bits0], [value]
        ORB     [value_after], [bits1], [value_after]
        IBXNE   leaf_segments, minus_one_index, r0, value_segment, leaf_segments
        BIM     value_next
value_patch:
        find_slot leaf_first_event
value_crossing:
        crossing_near bits0, bits1
        ORB     [value_after], [bits0], [value_after]
        ADDX    slot, slot_size, slot
        IBXNE   leaf_events, minus_one_index, r0, value_crossing, leaf_events
value_next:
        leaves_next value_leaf

; Evaluates the tree: each branch after those below it.
        load_branches
        RTOR    s3, branch_at
        IBXEQ   s2, r0, s3, tree_done
tree_branch:
        IX      branch_at, -64 * BRANCH_SIZE
        load_steps
tree_step:
        load_from step_at, T_SIZE, tree_operation
        value_of tree_left, left, left_after
        value_of tree_right, right, right_after
        value_of tree_result, value, value_after
        IBXEQ   tree_operation, r0, r0, tree_and
        IBXEQ   tree_operation, r0, one_index, tree_or
        both_values ANDNB
        BIM     tree_stepped
tree_and:
        both_values ANDB
        BIM     tree_stepped
tree_or:
        both_values ORB
tree_stepped:
        IX      step_at, 64 * T_SIZE
        IBXNE   steps_left, minus_one_index, r0, tree_step, steps_left
        IBXNE   branch_at, r0, s2, tree_branch
tree_done:
        tree_value
        XORB    [value], [value_after], [visible_rays]
        ANDB    [visible_rays], [active], [visible_rays]
        if_none visible_rays, s0, visible_rays_found

; Finds rays for which another primitive changes than that of the event.
        XORB    [inside], [inside], [inside]
        leaves_begin
other_leaf:
        leaf_with_value
        XORB    [value], [value_after], [bits0]
        ANDB    [bits0], [visible_rays], [bits0]
        if_none bits0, s1, other_next
        load_field P_ID, identity
        keep_where CMPNEV, [event_primitive], identity, bits0, bits1
        ORB     [inside], [bits0], [inside]
        IBXNE   shadows, r0, r0, other_next
        mark_tested
other_next:
        leaves_next other_leaf
        if_none inside, s1, visible_rays_found

; Computes which nodes show, into the bits of before. If a value stays the same,
; its parts do not show.
        tree_value
        ORB     [visible_rays], [visible_rays], [value]
        load_branches
        RTOR    s2, branch_at
show_branch:
        load_steps
        ES      s0, 64 * T_SIZE
        MPYX    steps_left, s0, s0
        ADDX    step_at, s0, step_at
show_parts:
        IX      step_at, -64 * T_SIZE
        load_from step_at, T_SIZE, tree_operation
        value_of tree_result, value, value_after
        value_of tree_left, left, left_after
        value_of tree_right, right, right_after
        XORB    [left], [left_after], [left]
        XORB    [right], [right_after], [right]
        ANDB    [left], [value], [left]
        ANDB    [right], [value], [right]
        IBXNE   steps_left, minus_one_index, r0, show_parts, steps_left
        IX      branch_at, 64 * BRANCH_SIZE
        IBXNE   branch_at, r0, s3, show_branch

; Finds the first primitive that shows, and the rays whose event is a crossing
; of a primitive that shows.
        XORB    [visible_rays], [visible_rays], [visible_rays]
        VTOV    big, [event_primitive]
        leaves_begin
shown_leaf:
        leaf_with_value
        if_none value, s0, shown_next
        XORB    [inside], [inside], [inside]
        find_slot leaf_first_event
shown_crossing:
        crossing_near bits0, bits1
        ORB     [inside], [bits0], [inside]
        CMPEQV  [slot], [column], [bits0]
        ANDB    [bits0], [value], [bits0]
        ORB     [visible_rays], [bits0], [visible_rays]
        ADDX    slot, slot_size, slot
        IBXNE   leaf_events, minus_one_index, r0, shown_crossing, leaf_events
        load_field P_ID, identity
        CMPLTV  identity, [event_primitive], [bits0]
        ANDB    [inside], [value], [inside]
        ANDB    [inside], [bits0], [inside]
        VTOV    identity, [event_primitive] ? [inside]
shown_next:
        leaves_next shown_leaf
        CNTOB   [visible_rays], s0
visible_rays_found:
        BIM     0, link_inner

; Sets bits0 to the rays of s5 that hit the leaf, and before, after to the range
; of their distances.
        .macro  found_rays
        load_field P_ID, identity
        CMPEQV  [event_primitive], identity, [bits0]
        ANDB    [s5], [bits0], [bits0]
        if_none bits0, s0, found_next
        load_word k_delta, s0
        SUBNV   [event], s0, [before]
        ADDNV   [event], s0, [after]
        .endm

; Copies the word after this crossing to hit_s, for the rays that have the
; crossing. Branches to `other` if none has it.
        .macro  found_at other
        crossing_near bits1, bits2
        ANDB    [bits0], [bits1], [bits1]
        if_none bits1, s0, \other
        ANDNB   [bits0], [bits1], [bits0]
        take_found ray_index, taken_at, 0, bits1
        ADDX    slot, s3, s4
        take_found s4, taken_distance, 1, bits1
        VTOVX   [taken_at], [taken_distance], [hit_s]
        .endm

; Makes the s9 rays of active the only current rays.
        .macro  compress_slots count, first
        RTOR    \count, s2
        find_slot \first
compress_slot\@:
        RTOR    slot, s3
        CPSV    [s3], [s3] ? [active]
        ADDX    slot, slot_size, slot
        IBXNE   s2, minus_one_index, r0, compress_slot\@, s2
        .endm

compress_rays:
        leaves_begin
compress_leaf:
        load_leaf_record
        .if     MESH_CROSSINGS
        unless_mesh compress_no_mesh
        IBXNE   shadows, r0, r0, compress_triangles
        triangles_offset s4
        ADDX    leaf_first_event, s4, s4
        compress_slots leaf_events, s4
compress_triangles:
        IBXEQ   leaf_segments, r0, r0, compress_patch_slots
compress_no_mesh:
        .endif
        IBXEQ   leaf_segments, r0, r0, compress_patch
        ADDX    leaf_segments, leaf_segments, leaf_segments
        compress_slots leaf_segments, leaf_first_state
        IBXEQ   leaf_first_state, r0, leaf_first_event, compress_next
        compress_slots leaf_events, leaf_first_event
        BIM     compress_next
compress_patch:
        IBXNE   shadows, r0, r0, compress_patch_slots
        ES      leaf_events, 3 * PATCH_CROSSINGS ; with its parameters
compress_patch_slots:
        compress_slots leaf_events, leaf_first_event
compress_next:
        leaves_next compress_leaf
        leave_only ray_index, ray_index_store, 0, active
        leave_only near_limit, ray_index_store, 1, active
        set_near s9
        set_events
        EQVB    [active], [active], [active]
        BIM     0, link_inner

; Accepts hits that are nearer than the ray's hit, or equally near and on an
; earlier primitive. s5: the rays of visible_rays that accept it.
found_nearest:
        take_found ray_index, taken_at, 0, visible_rays
        take_found event, taken_distance, 1, visible_rays
        take_found event_primitive, taken_primitive, 2, visible_rays
        RTOR    visible_rays, s5
        .if     KEYS
        take_found event, taken_depth, 3, visible_rays
        LTOR    taken_at, s2
        describe s4, found_bits, s2
        leaves_begin
found_counted:
        load_leaf_record
        load_record P_ID, 1, identity
        load_field P_TIE_OFFSET, s3
        CFPEQ   s3, r0, found_counted_next
        load_word k_delta, s2
        MPYS    s3, s2, s3
        CMPEQV  [taken_primitive], identity, [s4]
        ADDNV   [taken_distance], s3, [taken_distance] ? [s4]
found_counted_next:
        leaves_next found_counted
        .endif
        load_word walk_last, s0
        IBXEQ   s0, r0, r0, found_taken
        LTOR    taken_at, s2
        describe s3, found_store, s2
        describe s4, found_bits, s2
        VXTOV   [taken_at], [nearest], [s3]
        CMPLTV  [taken_distance], [s3], [s4]
        CNTOB   [s4], s0
        IBXEQ   s0, r0, s2, found_taken
        describe s6, found_bits + 64 * QUEUE_BIT_WORDS, s2
        describe s7, found_bits + 64 * QUEUE_BIT_WORDS * 2, s2
        CMPEQV  [taken_distance], [s3], [s6]
        VXTOV   [taken_at], [nearest_primitive], [s3]
        keep_where CMPLTV, [taken_primitive], [s3], s6, s7
        ORB     [s4], [s6], [s4]
        if_none s4, s0, found_none
        CPSV    [taken_at], [taken_at] ? [s4]
        CPSV    [taken_distance], [taken_distance] ? [s4]
        CPSV    [taken_primitive], [taken_primitive] ? [s4]
        .if     KEYS
        CPSV    [taken_depth], [taken_depth] ? [s4]
        .endif
        XORB    [bits1], [bits1], [bits1]
        MRGB    [s4], [bits1], [inside] ? [visible_rays]
        RTOR    inside, s5
found_taken:
        region_took_hits
        VTOVX   [taken_at], [taken_distance], [nearest]
        VTOVX   [taken_at], [taken_primitive], [nearest_primitive]
        scatter_depth taken_depth

; Stores the parameters of the rays of s5 whose event_primitive is a patch or a
; mesh.
found_points:
        leaves_begin
found_leaf:
        load_leaf_record
        .if     MESH_CROSSINGS
        load_field P_ON_PATCH, s0
        SHIFTI  s0, -1, s0
        IBXEQ   s0, r0, one_index, found_mesh
        .endif
        IBXNE   leaf_segments, r0, r0, found_next
        found_rays
        find_slot leaf_first_event
        EX      s3, 64 * CROSSING_SIZE * PATCH_CROSSINGS
found_crossing:
        found_at found_other
        ADDX    s4, s3, s4
        take_found s4, taken_distance, 1, bits1
        VTOVX   [taken_at], [taken_distance], [hit_t]
found_other:
        ADDX    slot, slot_size, slot
        IBXNE   leaf_events, minus_one_index, r0, found_crossing, leaf_events
found_next:
        leaves_next found_leaf
found_none:
        BIM     0, link_kernel

        .if     MESH_CROSSINGS
; Finds the triangle of a mesh, and whether the rays leave there. Every second
; crossing leaves a solid. The normals of a mesh with a body decide this.
found_mesh:
        found_rays
        triangles_offset s3
        find_slot leaf_first_event
        ES      s6, 0
found_triangle:
        found_at found_later
        VTOVX   [taken_at], s6, [hit_t]
found_later:
        ADDX    slot, slot_size, slot
        IBXEQ   leaf_segments, r0, r0, found_enters
        IBXNE   leaf_first_state, r0, leaf_first_event, found_enters
        XOR     s6, one_index, s6
found_enters:
        IBXNE   leaf_events, minus_one_index, r0, found_triangle, leaf_events
        BIM     found_next
        .endif
        .endkernel
