; nodes_scalar.s - intersects a ray with the primitives of a tree.
;
; nodes_vector.s describes the walk. The kernels of primitives store their
; crossings at P_FIRST_STATE and P_FIRST_EVENT. P_NEXT_HIT chains the primitives
; that the ray hits, beginning in span. Branches that the ray comes near are
; listed. The value of a missed node is 0.
;
; Required primitives narrow the span in which the tree can be visible
; (span_scalar.s). If nothing of it is left, the work ends.
;
; Part of the subroutines that walk, called by w_back. The region's own bound
; replaces that of the first node.
;
; In:  w_ray .., the region, w_end: the ray's limit.
; Out: w_hit = 1 if something may be visible, then between w_least and w_end;
;      the branches and leaves that the ray hits, in span (visible_scalar.s).

        .data
leaf_list:      .space 3
        .code

        .macro  load_node
        RTOR    w_node, w_at
        load_from w_at, NODE_LOADED, n_cx
        .endm

; Calls the leaf's kernel. l_crossing describes the third argument.
        .macro  call_leaf
        EX      arguments, leaf_list
        STO     [arguments], w_ray
        STO     [arguments, m_index_one], n_primitive
        IX      arguments, 64 * 2
        STO     [arguments], l_crossing
        EX      arguments, leaf_list
        BSAVE   link, [target]
        .endm

        .kernel visible
intersect_tree:
        load_two_delta
        EX      w_chain, span + 64 * 3
        load_word scene_branches, w_branch
        ES      w_hit, 0
        RTOR    w_lower, w_least
        RTOR    w_nodes, w_node
        load_node
        BIM     intersect_near
        .endkernel
        .kernel bound
intersect_node:
        load_node
        skip_far n_cx, n_cy, n_cz, n_radius, n_square, w_end, intersect_far
        .endkernel
        .kernel call
intersect_near:
        IBXNE   n_primitive, r0, r0, intersect_leaf
        IX      w_node, 64 * N_SIZE
        STO     [w_branch], n_steps
        STO     [w_branch, m_index_one], n_step_count
        IBXEQ   n_step_count, r0, r0, intersect_no_branch
        IX      w_branch, 64 * BRANCH_SIZE
intersect_no_branch:
        IBXNE   w_node, r0, w_nodes_end, intersect_node
        BIM     intersect_end
intersect_leaf:
        load_part n_primitive, P_STATE_KERNEL, 7, l_state_kernel, w_at
        IBXEQ   l_state_kernel, r0, r0, intersect_events
        ADDLEN  l_first_state, l_segments, l_crossing
        ADDLEN  l_crossing, l_segments, l_crossing
        RTOR    l_state_kernel, target
        RTOR    l_state_inner, inner
        call_leaf
intersect_events:
        ADDLEN  l_first_event, l_events, l_crossing
        load_from n_primitive, 2, target        ; target, inner
        call_leaf
        .if     MESH_CROSSINGS
        load_of n_primitive, P_SEGMENTS, l_segments ; a mesh sets its number
        .endif
        .endkernel

        .kernel visible
        RTOR    l_first_state, l_crossing
        LOD     [l_first_state], w_in
        CFPGE   w_in, m_big, intersect_missed
        STO     [w_chain], n_primitive
        address_of n_primitive, P_NEXT_HIT, w_chain
        ES      w_hit, 1
        IBXEQ   n_needed, r0, r0, intersect_next
        IBXEQ   l_segments, r0, r0, intersect_next
        narrow_span l_crossing, l_segments, m_index_one, intersect_nothing
intersect_next:
        IBXNE   n_next, r0, w_nodes_end, intersect_node, w_node
intersect_end:
        STO     [w_chain], r0
        store_word w_branch, span + 64 * 2, w_at
        BIM     0, w_back

intersect_far:
        IBXNE   n_needed, r0, r0, intersect_nothing
        STO     [n_value], r0
        IBXNE   n_next, r0, w_nodes_end, intersect_node, w_node
        BIM     intersect_end
intersect_missed:
        STO     [n_value], r0
        IBXEQ   n_needed, r0, r0, intersect_next
intersect_nothing:
        ES      w_hit, 0
        BIM     0, w_back
        .endkernel
