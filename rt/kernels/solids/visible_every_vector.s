; visible_every_vector.s - the crossings of a region that can be seen, all of
; them: the other way, under VISIBLE = EVERY (visible_vector.s has the choice).
;
; Each crossing of each primitive is a column, over all rays at hand:
;
;   E is looked at where  least < E < limit
;   seen, and what: as at an event that is stepped to
;   limit = E where seen
;
; So what is left in the end is the nearest.  No ray is left out on the way; a
; column that no ray needs is.
;
; A shadow's ray that passes clear parts goes on behind each of them: it is
; stepped along in any case.  Where all parts are opaque the nearest stops the
; light as well as any.
;
; In:  as walk_tree.  Source: the project's notes on ray tracing, 4.1.

; The leaf whose columns are looked at.
        .share  hits
        .regs   r144, columns_left, column_identity, column_leaf
        .reg    nearest_met, r148       ; what is seen at the nearest so far
        .endshare

        .data
        .align  64
nearest_met_store: .space QUEUE
        .code

        .kernel visible
walk_every:
        IBXEQ   shadows, r0, r0, every_solids
        RTOR    region, s0
        IX      s0, 64 * R_SHADOW
        LOD     [s0], s0
        IBXNE   s0, r0, one_index, tree_next
every_solids:
        describe nearest_met, nearest_met_store, near
        VTOV    [near_limit], [event]
        VTOV    r0, [nearest_met]
        leaves_begin
every_leaf:
        leaf_at_hand
        load_field P_ID, column_identity
        find_slot leaf_first_event
        RTOR    slot, column
        RTOR    leaf_events, columns_left
        RTOR    leaf_at, column_leaf
every_column:
        CMPLTV  [last], [column], [bits0]
        CMPLTV  [column], [event], [active]
        ANDB    [bits0], [active], [active]
        CNTOB   [active], s0
        IBXEQ   s0, r0, r0, every_later
        VTOV    column_identity, [event_met]
        EX      target, find_seen
        BSAVE   link_inner, [target]
        IBXEQ   s0, r0, r0, every_later
        VTOV    [column], [event] ? [seen]
        VTOV    [event_met], [nearest_met] ? [seen]
every_later:
        EX      slot_size, 64 * CROSSING_SIZE
        ADDX    column, slot_size, column
        IBXNE   columns_left, minus_one_index, r0, every_column, columns_left
        RTOR    column_leaf, leaf_at
        leaves_next every_leaf
        RTOR    nearest_met, event_met
        CMPNEV  [event_met], r0, [seen]
        CNTOB   [seen], s0
        IBXEQ   s0, r0, r0, walk_skip
        BSAVE   link_kernel, [found]
        BIM     walk_skip
        .endkernel
