; hierarchy_scalar.s - walks through the hierarchy of regions, for one ray.
;
; The walk starts with the regions outside the hierarchy and continues with
; those below nodes that the ray comes near. Nodes to be visited are on a stack,
; with 0 at its bottom. The child node that is nearer along the ray is visited
; first, because its hits limit the search in the other one. A leaf with one
; region is not tested, because the region is.
;
; These macros are parts of the walks. The results do not depend on the order of
; the regions (regions_scalar.s, shadow_scalar.s).
; Source: derived here; the project's notes on ray tracing, 4.1.

; A node. It uses registers of the trees, which are free here.
        .share  local
        .regs   r62, h_cx, h_cy, h_cz, h_radius, h_square
        .regs   r67, h_regions, h_region_count, h_dirx, h_diry, h_dirz
        .reg    h_node, r75
        .endshare
        .equ    HIERARCHY_LOADED, H_DIRECTION + 3

        .data
hierarchy_stack: .space HIERARCHY_DEPTH + 2
        .code

        .macro  enter_hierarchy
        load_word scene_hierarchy, h_node
        EX      w_stack, hierarchy_stack + 64
        STO     [w_stack], h_node
        IX      w_stack, 64
        .endm

; Branches to `region` with the regions of the next leaf, or to `done` without
; one.
        .macro  next_leaf region, done
leaf_pop\@:
        IX      w_stack, -64
        LOD     [w_stack], h_node
        IBXEQ   h_node, r0, r0, \done
leaf_node\@:
        RTOR    h_node, w_at
        load_from w_at, HIERARCHY_LOADED, h_cx
        IBXEQ   h_region_count, r0, m_index_one, leaf_found\@
        skip_far h_cx, h_cy, h_cz, h_radius, h_square, w_limit, leaf_pop\@
        IBXNE   h_region_count, r0, r0, leaf_found\@
        three   MPYS, h_dirx, h_diry, h_dirz, w_dx, w_dy, w_dz, w_t0, w_t1, w_t2
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
