; nodes_vector.s - intersects the current rays with a region's primitives.
;
; The nodes are in preorder. If no ray comes near a node's bounding sphere, the
; node and everything below it are skipped. Its primitives are not active, and
; their crossings are not read. Active leaves and branches are listed. The
; kernels write directly into the region's crossings: tin, tout .. are
; descriptors of vectors there.
;
;   closed shape  P_SEGMENTS times in, out from P_FIRST_STATE on
;   open shape    the same for the closed shape; its own crossings from
;                 P_FIRST_EVENT on
;   patch         PATCH_CROSSINGS crossings, their s, their t, from
;                 P_FIRST_EVENT on
;   mesh          P_SEGMENTS times in, out, or P_EVENTS crossings, from
;                 P_FIRST_EVENT on (invisible mesh: P_FIRST_STATE); after the
;                 room for crossings their triangles
;
; Spheres with less than half of the region's radius are tested. Those of
; required nodes are not smaller than that. If few rays come near a node, those
; rays are gathered for everything below it (sparse_vector.s). After each
; primitive the walk continues at node_hit, with the segments in tin .., and
; after all primitives at walk_tree.
;
; After an earlier hit, crossings slightly beyond the limits are computed too.
; If two regions are hit at one distance, the first primitive wins, as
; found_nearest decides.
;
; In:  region, the current rays.
; Out: the crossings; the active leaves and branches, up to leaves_end and
;      branches_end; 0 as the value of distant nodes.
; Source: derived here; the project's notes on ray tracing, 4.1.

; A primitive's part in a tree: the words from P_SEGMENTS on.
        .share  scratch
        .regs   r246, leaf_primitive, leaf_segments, leaf_events
        .regs   r249, leaf_first_state, leaf_first_event, leaf_value
        .reg    slot, r252
        .reg    slot_size, r253
        .endshare

; The active leaves, stored consecutively.
        .share  crossings
        .regs   r105, first_leaf, leaves_last
        .endshare

        .macro  load_leaves
        load_words scene_leaves, 2, first_leaf, s0 ; first_leaf, leaves_last
        .endm

        .macro  leaves_begin
        RTOR    first_leaf, leaf_at
        .endm

        .macro  load_leaf_record
        load_from leaf_at, LEAF_NEEDED, leaf_primitive
        RTOR    leaf_primitive, primitive
        .endm

        .macro  leaves_next again
        IX      leaf_at, 64 * LEAF_SIZE
        IBXNE   leaf_at, r0, leaves_last, \again
        .endm

; Adds the current node to its list. The fields of a leaf are loaded.
        .macro  list_branch
        EX      s0, branches_end
        LOD     [s0], s1
        store_to node_steps, BRANCH_SIZE, s1    ; node_steps, node_step_count
        IX      s1, 64 * BRANCH_SIZE
        STO     [s0], s1
        .endm

        .macro  list_leaf
        EX      s0, leaves_end
        LOD     [s0], s1
        RTOR    node_primitive, primitive
        load_record P_SEGMENTS, 5, leaf_segments
        RTOR    primitive, leaf_primitive
        store_to leaf_primitive, LEAF_NEEDED, s1
        IX      s1, 64 * LEAF_NEEDED
        STO     [s1], node_needed
        IX      s1, 64 * (LEAF_SIZE - LEAF_NEEDED)
        STO     [s0], s1
        .endm

        .equ    CROSSING_SIZE, QUEUE

        .if     MESH_CROSSINGS
; Branches to `other` unless the primitive is a visible mesh whose crossings are
; all needed.
        .macro  unless_mesh other
        load_field P_ON_PATCH, s0
        SHIFTI  s0, -1, s0
        IBXNE   s0, r0, one_index, \other
        .endm

; Computes the offset from the mesh's crossings to their triangles.
        .macro  triangles_offset into
        load_field P_SHAPE + 1, \into
        FLR     \into, \into
        EX      s0, 64 * CROSSING_SIZE
        MPYX    \into, s0, \into
        .endm
        .endif

; The words of a node after its bound.
        .share  shape
        .regs   r61, node_steps, node_step_count, node_primitive, node_needed
        .regs   r65, node_after, node_value
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

; Clears both bits of the node's value for all rays of a full queue, because no
; ray is inside. It takes one instruction if a vector can have this length.
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

; slot := descriptor of the crossing at `first`; the next one is slot_size
; later.
        .macro  find_slot first
        EX      slot_size, 64 * CROSSING_SIZE
        ADDLEN  \first, near, slot
        .endm

        .macro  next_slot into
        RTOR    slot, \into
        ADDX    slot, slot_size, slot
        .endm

; Makes descriptors of the parameters of a patch's crossings, which start at
; tin.
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
        describe s3, ray_index_store + 64 * QUEUE, near
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
        call_routine begin_span, link_inner
        load_from node_at, NODE_WORDS, bound_x
        MPYS    bound_r, half, least_culled
        BIM     node_near                       ; the region's own bound
node_next:
        IBXEQ   node_at, r0, nodes_end, nodes_hit
        load_from node_at, NODE_WORDS, bound_x
        CFPGE   bound_r, least_culled, node_near
        set_rays wox, woy, woz, wdx, wdy, wdz, wlower
        RTOR    near, s8
        RTOR    near_limit, s9
        call_routine test_bound, link_inner
        IBXEQ   s0, r0, r0, node_far
        ADDX    s0, s0, s1
        ADDX    s1, s1, s1
        IBXGE   s1, r0, near, node_near
        .if     MESH_CROSSINGS
        IBXNE   node_mesh, r0, r0, node_near
        .endif
        load_word sparse_outer, s1
        IBXEQ   s1, r0, r0, node_sparse
        BIM     node_near
nodes_hit:
        load_word sparse_outer, s9
        IBXEQ   s9, r0, r0, walk_tree
        BIM     sparse_hit
node_far:
        clear_value
        RTOR    node_after, node_at
        BIM     node_next
node_near:
        IX      node_at, 64 * N_SIZE
        IBXNE   node_primitive, r0, r0, node_leaf
        IBXEQ   node_step_count, r0, r0, node_next
        list_branch
        BIM     node_next
node_leaf:
        load_word sparse_outer, s9
        list_leaf
        RTOR    node_needed, leaf_needed
        IBXNE   s9, r0, r0, sparse_leaf
        .endkernel

        .kernel call
        set_rays wox, woy, woz, wdx, wdy, wdz, wlower
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
        IBXEQ   s0, r0, r0, node_hit
        .endif
        load_record P_SEGMENTS, 4, leaf_segments
        find_segments leaf_first_state
        RTOR    leaf_segments, segments_wanted
        address_of primitive, P_STATE_KERNEL, shape_at
        call_kernel
        .if     MESH_CROSSINGS

; A mesh sets the number of its segments and events.
node_counted:
        load_field P_ON_PATCH, s0
        ES      s1, 2
        IBXLT   s0, r0, s1, node_hit
        load_record P_SEGMENTS, 2, s2           ; s2, s3
        load_word leaves_end, s0
        IX      s0, -64 * (LEAF_SIZE - LEAF_PART)
        store_to s2, 2, s0
        RTOR    s2, segments_wanted
        .endif
        BIM     node_hit
        .endkernel
