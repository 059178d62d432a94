; visible_every_vector.s - nearest visible crossings; tests every crossing.
;
; This is the method VISIBLE = EVERY (visible_vector.s has the choice). Each
; crossing of each primitive is a column over all current rays:
;
;   E is tested where  least < E < limit
;   visibility and primitive: as for an event in stepping
;   limit = E where it is visible
;
; The last limit is therefore the nearest visible crossing. No ray is compressed
; away, but a column that no ray needs is skipped.
;
; A shadow ray that passes clear parts continues after each of them, so it
; always uses stepping. If all parts are opaque, the nearest crossing blocks the
; light as well as any other.
;
; In: as walk_tree. Source: the project's notes on ray tracing, 4.1.

; The leaf whose columns are tested.
        .share  hits
        .regs   r144, columns_left, column_identity, column_leaf
        .reg    best_primitive, r148    ; primitive at the nearest so far
        .endshare

        .data
        .align  64
best_primitive_store: .space QUEUE
        .code

        .kernel visible
walk_every:
        IBXEQ   shadows, r0, r0, every_solids
        load_of region, R_SHADOW, s0
        IBXNE   s0, r0, one_index, tree_next
every_solids:
        describe best_primitive, best_primitive_store, near
        VTOV    [near_limit], [event]
        VTOV    r0, [best_primitive]
        leaves_begin
every_leaf:
        load_leaf_record
        load_field P_ID, column_identity
        find_slot leaf_first_event
        RTOR    slot, column
        RTOR    leaf_events, columns_left
        RTOR    leaf_at, column_leaf
every_column:
        CMPLTV  [last], [column], [bits0]
        CMPLTV  [column], [event], [active]
        ANDB    [bits0], [active], [active]
        if_none active, s0, every_later
        VTOV    column_identity, [event_primitive]
        call_routine find_visible, link_inner
        IBXEQ   s0, r0, r0, every_later
        VTOV    [column], [event] ? [visible_rays]
        VTOV    [event_primitive], [best_primitive] ? [visible_rays]
every_later:
        EX      slot_size, 64 * CROSSING_SIZE
        ADDX    column, slot_size, column
        IBXNE   columns_left, minus_one_index, r0, every_column, columns_left
        RTOR    column_leaf, leaf_at
        leaves_next every_leaf
        RTOR    best_primitive, event_primitive
        CMPNEV  [event_primitive], r0, [visible_rays]
        if_none visible_rays, s0, walk_skip
        BSAVE   link_kernel, [found]
        BIM     walk_skip
        .endkernel
