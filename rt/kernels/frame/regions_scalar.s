; regions_scalar.s - what one ray meets first.
;
;       CALL NEAREST (RAY, HIT)
;
; RAY = O, D, the least distance that counts, and the same enlarged, to be
; scaled (8 words); HIT = distance, address of the primitive's
; record (0: none).
;
; Region by region (hierarchy_scalar.s) the nearer wins, of equals the first of
; the scene, in whatever order they are met.  Of a simple region the hit is tin
; if it lies beyond the least distance, else tout.  The crossings of a tree are
; collected (nodes_scalar.s) and searched by VISIBLE, a little farther than the
; nearest so far, for another may be as near.  Where a ray does not come near,
; nothing more is done.
; On a patch the parameters are left in the primitive's P_PATCH_POINT; in a tree
; they are those of its first crossing within delta of that distance.

        .data
nearest_save:   .space WALK_REGISTERS
segment:        .space 2
kernel_list:    .descriptor 6, 0
kernel_primitive: .word 0
                .descriptor 2, segment
        .code

        .macro  enter_walk save, registers, number
        EX      save_at, \save
        ELEN    save_at, \registers
        SWAP    [r0], w_ray, [save_at]
        EX      w_at, bound_less
        LOD     [w_at], w_less
        RTOR    link, w_link
        ELEN    arguments, \number
        SWAP    [arguments], w_ray, [r0]
        RTOR    w_ray, w_at
        ELEN    w_at, 7
        SWAP    [w_at], w_ox, [r0]
        EX      w_at, kernel_list
        STO     [w_at], w_ray
        EX      w_at, own_space
        STO     [w_at], r0
        EX      w_at, scene_regions
        ELEN    w_at, 2
        SWAP    [w_at], w_region, [r0]
        enter_hierarchy
        .endm

        .macro  leave_walk save, registers
        RTOR    w_link, link
        leave   \save, \registers
        .endm

; The next region, as long as there are any.
        .macro  next_region again
        IX      w_region, 64 * R_SIZE
        IBXNE   w_regions_left, m_index_minus_one, r0, \again, w_regions_left
        .endm

        .macro  load_region
        RTOR    w_region, w_at
        ELEN    w_at, REGION_LOADED
        SWAP    [w_at], w_cx, [r0]
        .endm

; The segment of a simple region: the crossing that counts in w_in, to near if it
; is before the limit, to miss if there is none.
        .macro  meet_simple near, miss
        EX      w_at, kernel_primitive
        STO     [w_at], w_first
        ELEN    w_first, 2
        SWAP    [w_first], target, [r0]         ; and inner
        EX      arguments, kernel_list
        BSAVE   link, [target]
        EX      w_at, segment
        ELEN    w_at, 2
        SWAP    [w_at], w_in, [r0]
        .endkernel
        .kernel visible
        CFPLT   w_lower, w_in, simple_ahead\@
        RTOR    w_out, w_in
        CFPGE   w_lower, w_in, \miss
simple_ahead\@:
        CFPLT   w_in, w_limit, \near
        .endm

; The parameters of the crossing at w_in, seen on w_leaf (and w_out), of a tree: to its
; P_PATCH_POINT, if it is a patch or a mesh; then to done.
        .macro  note_point done
        RTOR    w_out, w_at
        IX      w_at, 64 * P_ON_PATCH
        LOD     [w_at], w_t0
        IBXEQ   w_t0, r0, r0, \done
        IX      w_out, 64 * P_FIRST_EVENT
        LOD     [w_out], w_t1
        RTOR    w_leaf, w_at
        .if     MESH_CROSSINGS
        SHIFTI  w_t0, -1, w_t2
        IBXEQ   w_t2, r0, m_index_one, point_triangle\@
        .endif
        IX      w_at, 64 * (P_PATCH_POINTS - 2)
        EX      w_t2, k_delta
        LOD     [w_t2], w_t2
        SUBN    w_in, w_t2, w_t3
        ADDN    w_in, w_t2, w_t4
point_crossing\@:
        LOD     [w_t1], w_t2
        IX      w_t1, 64
        IX      w_at, 64 * 2
        CFPLT   w_t2, w_t3, point_crossing\@
        CFPLT   w_t4, w_t2, point_crossing\@
        ELEN    w_at, 2
        SWAP    [w_at], w_t0, [r0]              ; and w_t1
        RTOR    w_leaf, w_at
        IX      w_at, 64 * P_PATCH_POINT
        ELEN    w_at, 2
        SWAP    [r0], w_t0, [w_at]
        BIM     \done

        .if     MESH_CROSSINGS
; On which triangle of a mesh, and 1 if the ray leaves there: of a solid where each
; second crossing is.
point_triangle\@:
        RTOR    w_leaf, w_at
        IX      w_at, 64 * (P_SHAPE + 1)
        LOD     [w_at], w_t5
        FLR     w_t5, w_t5                      ; triangles stand so far behind
        IX      w_at, 64 * (P_SEGMENTS - P_SHAPE - 1)
        LOD     [w_at], w_t6
        ES      w_t2, 2
        IBXEQ   w_t0, r0, w_t2, point_sided\@
        RTOR    r0, w_t6                        ; its normals tell
point_sided\@:
        EX      w_t2, k_delta
        LOD     [w_t2], w_t2
        SUBN    w_in, w_t2, w_t3
        ADDN    w_in, w_t2, w_t4
        RTOR    w_t1, w_t0                      ; the first
point_mesh_crossing\@:
        LOD     [w_t1], w_t2
        IX      w_t1, 64
        CFPLT   w_t2, w_t3, point_mesh_crossing\@
        CFPLT   w_t4, w_t2, point_mesh_crossing\@
        IX      w_t1, -64
        SUBX    w_t1, w_t0, w_t2
        LOD     [w_t1, w_t5], w_t0
        RTOR    r0, w_t1
        IBXEQ   w_t6, r0, r0, point_enters\@
        SHIFTI  w_t2, -6, w_t2
        AND     w_t2, m_index_one, w_t1
point_enters\@:
        RTOR    w_leaf, w_at
        IX      w_at, 64 * P_PATCH_POINT
        ELEN    w_at, 2
        SWAP    [r0], w_t0, [w_at]
        BIM     \done
        .endif
        .endm

        .kernel visible
nearest:
        enter_walk nearest_save, WALK_REGISTERS, 2
        EX      w_at, k_far
        LOD     [w_at], w_limit
        ES      w_leaf, 0
        IBXEQ   w_regions_left, r0, r0, nearest_leaf
        .endkernel
        .kernel bound
nearest_region:
        load_region
        skip_far w_cx, w_cy, w_cz, w_radius, w_square, w_limit, nearest_skip
        .endkernel
        .kernel call
        IBXNE   w_way, r0, m_index_one, nearest_other
nearest_simple:
        meet_simple nearest_hit, nearest_skip
        CFPNE   w_in, w_limit, nearest_skip
        IBXGE   w_first, r0, w_leaf, nearest_skip
nearest_hit:
        RTOR    w_in, w_limit
        RTOR    w_first, w_leaf
        .endkernel
        .kernel bound
nearest_skip:
        next_region nearest_region
nearest_leaf:
        next_leaf nearest_region, nearest_done
        .endkernel
        .kernel visible
nearest_done:
        SWAP    [r0], w_limit, [w_argument]
        leave_walk nearest_save, WALK_REGISTERS
        .endkernel
        .kernel bound
nearest_other:
        meet_box nearest_tree, nearest_simple, nearest_skip
        .endkernel
        .kernel visible
nearest_tree:
        EX      w_at, bound_more
        LOD     [w_at], w_end
        MPYS    w_limit, w_end, w_end
        EX      target, meet_tree
        BSAVE   w_back, [target]
        IBXEQ   w_met, r0, r0, nearest_skip
        next_visible w_least, nearest_skip
        CFPLT   w_in, w_limit, nearest_seen
        CFPNE   w_in, w_limit, nearest_skip
        IBXGE   w_out, r0, w_leaf, nearest_skip
nearest_seen:
        RTOR    w_in, w_limit
        RTOR    w_out, w_leaf
        note_point nearest_skip
        .endkernel
