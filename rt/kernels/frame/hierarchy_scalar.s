; hierarchy_scalar.s - from the regions that stand under no node of the hierarchy
; to those under nodes that a ray comes near.
;
; The nodes that are left stand in a stack, the next one on top, 0 at its bottom.
; Of two nodes below another the one that lies ahead is looked at first, for its
; hits shorten the way to the other.  A leaf with one region is not tested, for
; the region is.
;
; Parts of those that walk, as macros.  What they find does not depend on the
; order (regions_scalar.s, shadow_scalar.s).
; Source: derived here; the project's notes on ray tracing, 4.1.

; A node, while no tree is met.
        .share  local
        .regs   r62, h_cx, h_cy, h_cz, h_radius, h_square
        .regs   r67, h_regions, h_region_count, h_wayx, h_wayy, h_wayz
        .reg    h_node, r75
        .endshare
        .equ    HIERARCHY_LOADED, H_WAY + 3

        .data
hierarchy_stack: .space HIERARCHY_DEPTH + 2
        .code

        .macro  enter_hierarchy
        EX      w_at, scene_hierarchy
        LOD     [w_at], h_node
        EX      w_stack, hierarchy_stack + 64
        STO     [w_stack], h_node
        IX      w_stack, 64
        .endm

; The regions of the next leaf, to region; to done if there are no more.
        .macro  next_leaf region, done
leaf_pop\@:
        IX      w_stack, -64
        LOD     [w_stack], h_node
        IBXEQ   h_node, r0, r0, \done
leaf_node\@:
        RTOR    h_node, w_at
        ELEN    w_at, HIERARCHY_LOADED
        SWAP    [w_at], h_cx, [r0]
        IBXEQ   h_region_count, r0, m_index_one, leaf_found\@
        skip_far h_cx, h_cy, h_cz, h_radius, h_square, w_limit, leaf_pop\@
        IBXNE   h_region_count, r0, r0, leaf_found\@
        MPYS    h_wayx, w_dx, w_t0
        MPYS    h_wayy, w_dy, w_t1
        MPYS    h_wayz, w_dz, w_t2
        IX      h_node, 64 * H_SIZE
        ADDN    w_t0, w_t1, w_t0
        ADDN    w_t0, w_t2, w_t0
        CFPGE   w_t0, r0, leaf_push\@
        STO     [w_stack], h_node
        IX      w_stack, 64
        RTOR    h_regions, h_node
        BIM     leaf_node\@
leaf_push\@:
        STO     [w_stack], h_regions
        IX      w_stack, 64
        BIM     leaf_node\@
leaf_found\@:
        RTOR    h_regions, w_region
        RTOR    h_region_count, w_regions_left
        BIM     \region
        .endm
