; nodes_vector.s - the crossings of the rays at hand with a region's primitives.
;
; The nodes stand in preorder.  A node whose bounding sphere no ray comes near
; is passed over with all that is below it; those primitives are not at hand,
; and nothing looks at their crossings.  The others are listed, and the kernels write
; into the region's crossings directly: tin, tout .. are descriptors of vectors
; there.
;
;   closed shape    P_SEGMENTS times in, out from P_FIRST_STATE on
;   open shape      likewise those of the closed one; its own crossings
;                   from P_FIRST_EVENT on
;   patch           PATCH_CROSSINGS crossings, as many s, as many t from
;                   P_FIRST_EVENT on
;   mesh            P_SEGMENTS times in, out, or P_EVENTS crossings, and behind
;                   the room for them their triangles, from P_FIRST_EVENT on; of
;                   one that is not seen from P_FIRST_STATE on
;
; Spheres of less than half of the region's radius are tested; those of needed nodes
; are no smaller than it.  Where few rays come near a node those are gathered for all
; that is below it (sparse_vector.s).  Behind each primitive it goes on at node_met, with
; the segments in tin ..; behind all of them at walk_tree.
;
; Where something has been met before, crossings a little beyond the limits are
; looked for, too: of two regions at one distance the first primitive counts,
; which found_nearest decides.
;
; In:  region, the rays at hand.  Out: the crossings; the leaves and branches at
;      hand, up to leaves_end and branches_end; 0 as the value of what is far.
; Source: derived here; the project's notes on ray tracing, 4.1.

; A primitive's part in a tree: the words from P_SEGMENTS on.
        .share  scratch
        .regs   r246, leaf_primitive, leaf_segments, leaf_events
        .regs   r249, leaf_first_state, leaf_first_event, leaf_value
        .reg    slot, r252
        .reg    slot_size, r253
        .endshare

; The leaves at hand, one after another.
        .share  crossings
        .regs   r105, first_leaf, leaves_last
        .endshare

        .macro  load_leaves
        EX      s0, scene_leaves
        ELEN    s0, 2
        SWAP    [s0], first_leaf, [r0]          ; and leaves_last
        .endm

        .macro  leaves_begin
        RTOR    first_leaf, leaf_at
        .endm

        .macro  leaf_at_hand
        ELEN    leaf_at, LEAF_NEEDED
        SWAP    [leaf_at], leaf_primitive, [r0]
        RTOR    leaf_primitive, primitive
        .endm

        .macro  leaves_next again
        IX      leaf_at, 64 * LEAF_SIZE
        IBXNE   leaf_at, r0, leaves_last, \again
        .endm

; The node at hand goes to its list.  Of a leaf the parts are loaded.
        .macro  list_branch
        EX      s0, branches_end
        LOD     [s0], s1
        ELEN    s1, BRANCH_SIZE
        SWAP    [r0], node_steps, [s1]          ; and node_step_count
        IX      s1, 64 * BRANCH_SIZE
        STO     [s0], s1
        .endm

        .macro  list_leaf
        EX      s0, leaves_end
        LOD     [s0], s1
        RTOR    node_primitive, primitive
        load_record P_SEGMENTS, 5, leaf_segments
        RTOR    primitive, leaf_primitive
        ELEN    s1, LEAF_NEEDED
        SWAP    [r0], leaf_primitive, [s1]
        IX      s1, 64 * LEAF_NEEDED
        STO     [s1], node_needed
        IX      s1, 64 * (LEAF_SIZE - LEAF_NEEDED)
        STO     [s0], s1
        .endm

        .equ    CROSSING_SIZE, QUEUE

        .if     MESH_CROSSINGS
; To other if the primitive is not a mesh all of whose crossings are asked, and
; that is seen.
        .macro  unless_mesh other
        load_field P_ON_PATCH, s0
        SHIFTI  s0, -1, s0
        IBXNE   s0, r0, one_index, \other
        .endm

; Words from its crossings on to their triangles.
        .macro  triangles_behind into
        load_field P_SHAPE + 1, \into
        FLR     \into, \into
        EX      s0, 64 * CROSSING_SIZE
        MPYX    \into, s0, \into
        .endm
        .endif

; The words of a node behind its bound.
        .share  shape
        .regs   r61, node_steps, node_step_count, node_primitive, node_needed
        .regs   r65, node_behind, node_value
        .if     MESH_CROSSINGS
        .reg    node_mesh, r67
        .endif
        .endshare
        .if     MESH_CROSSINGS
        .equ    NODE_WORDS, N_MESH + 1
        .else
        .equ    NODE_WORDS, N_VALUE + 1
        .endif
        .share  phase
        .reg    leaf_needed, r188
        .reg    least_culled, r187      ; smaller bounds are tested
        .endshare

; No ray is inside of the node: both bits of its value, of all rays that the queue
; may have, in one go if a vector can be so long.
        .macro  clear_value
        .if     VALUE_SIZE == 1
        STO     [node_value], r0
        .else
        RTOR    node_value, s2
        .if     64 * VALUE_SIZE > 65535
        ELEN    s2, 32 * VALUE_SIZE - 64
        XORB    [s2], [s2], [s2]
        IX      s2, 64
        XORB    [s2], [s2], [s2]
        IX      s2, 32 * VALUE_SIZE - 64
        XORB    [s2], [s2], [s2]
        IX      s2, 64
        .else
        ELEN    s2, 64 * VALUE_SIZE
        .endif
        XORB    [s2], [s2], [s2]
        .endif
        .endm

; slot := descriptor of the crossing at first, the next one slot_size on.
        .macro  find_slot first
        EX      slot_size, 64 * CROSSING_SIZE
        ADDLEN  \first, near, slot
        .endm

        .macro  next_slot into
        RTOR    slot, \into
        ADDX    slot, slot_size, slot
        .endm

; Where the parameters of a patch's crossings go, which are from tin on.
        .macro  find_parameters
        EX      s0, 64 * CROSSING_SIZE * PATCH_CROSSINGS
        ADDX    tin, s0, patch_s
        ADDX    patch_s, s0, patch_t
        ES      segments_wanted, PATCH_CROSSINGS / 2
        .endm

        .macro  find_segments first
        find_slot \first
        next_slot tin
        next_slot tout
        next_slot tin2
        next_slot tout2
        next_slot tin3
        next_slot tout3
        .endm

        .kernel bound
walk_nodes:
        IBXNE   shadows, r0, r0, walk_limited
        load_word walk_last, s0
        IBXEQ   s0, r0, r0, walk_limited
        load_word bound_more, s0
        describe s3, place_store + 64 * QUEUE, near
        .if     KEYS
        load_word k_delta, s1
        LINKV
        MPYSV   [near_limit], s0, [s3]
        ADDNV   [s3], s1, [s3]
        .else
        MPYSV   [near_limit], s0, [s3]
        .endif
        RTOR    s3, near_limit
walk_limited:
        RTOR    region_nodes, node_at
        RTOR    region_nodes_end, nodes_end
        load_word scene_leaves, s0
        load_word scene_branches, s1
        EX      s2, leaves_end
        EX      s3, branches_end
        STO     [s2], s0
        STO     [s3], s1
        EX      target, begin_span
        BSAVE   link_inner, [target]
        ELEN    node_at, NODE_WORDS
        SWAP    [node_at], bound_x, [r0]
        MPYS    bound_r, half, least_culled
        BIM     node_near                       ; the region's own bound
node_next:
        IBXEQ   node_at, r0, nodes_end, nodes_met
        ELEN    node_at, NODE_WORDS
        SWAP    [node_at], bound_x, [r0]
        CFPGE   bound_r, least_culled, node_near
        look_at_rays wox, woy, woz, wdx, wdy, wdz, wlower
        RTOR    near, s8
        RTOR    near_limit, s9
        EX      target, test_bound
        BSAVE   link_inner, [target]
        IBXEQ   s0, r0, r0, node_far
        ADDX    s0, s0, s1
        ADDX    s1, s1, s1
        IBXGE   s1, r0, near, node_near
        .if     MESH_CROSSINGS
        IBXNE   node_mesh, r0, r0, node_near
        .endif
        load_word few_outer, s1
        IBXEQ   s1, r0, r0, node_few
        BIM     node_near
nodes_met:
        load_word few_outer, s9
        IBXEQ   s9, r0, r0, walk_tree
        BIM     few_met
node_far:
        clear_value
        RTOR    node_behind, node_at
        BIM     node_next
node_near:
        IX      node_at, 64 * N_SIZE
        IBXNE   node_primitive, r0, r0, node_leaf
        IBXEQ   node_step_count, r0, r0, node_next
        list_branch
        BIM     node_next
node_leaf:
        load_word few_outer, s9
        list_leaf
        RTOR    node_needed, leaf_needed
        IBXNE   s9, r0, r0, few_leaf
        .endkernel

        .kernel call
        look_at_rays wox, woy, woz, wdx, wdy, wdz, wlower
        find_segments leaf_first_event
        RTOR    leaf_segments, segments_wanted
        IBXNE   leaf_segments, r0, r0, node_solid
        ES      leaf_needed, 0
        find_parameters
        RTOR    primitive, shape_at
        call_kernel
        leave_parameters
        BIM     node_listed
node_solid:
        RTOR    primitive, shape_at
        call_kernel
node_listed:
        load_field P_STATE_KERNEL, s0
        .if     MESH_CROSSINGS
        IBXEQ   s0, r0, r0, node_counted
        .else
        IBXEQ   s0, r0, r0, node_met
        .endif
        load_record P_SEGMENTS, 4, leaf_segments
        find_segments leaf_first_state
        RTOR    leaf_segments, segments_wanted
        RTOR    primitive, shape_at
        IX      shape_at, 64 * P_STATE_KERNEL
        call_kernel
        .if     MESH_CROSSINGS

; A mesh tells how many segments and events there are.
node_counted:
        load_field P_ON_PATCH, s0
        ES      s1, 2
        IBXLT   s0, r0, s1, node_met
        load_record P_SEGMENTS, 2, s2           ; and s3
        load_word leaves_end, s0
        IX      s0, -64 * (LEAF_SIZE - LEAF_PART)
        ELEN    s0, 2
        SWAP    [r0], s2, [s0]
        RTOR    s2, segments_wanted
        .endif
        BIM     node_met
        .endkernel
