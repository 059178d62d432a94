; regions_scalar.s - finds the nearest hit of one ray.
;
;       CALL NEAREST (RAY, HIT)
;
; RAY = O, D, the least distance, and the least distance enlarged, to be scaled
; (8 words). With INTERIORS the rank of the surface that it passed follows
; (CHILD_PASSED). HIT = distance, address of the primitive's record (0: none).
; With HIDDEN there is a third argument: CLASS = IMAGE_RAYS or REFLECTED_RAYS.
; Regions hidden from this class are skipped.
;
; The ray is tested against one region after another (hierarchy_scalar.s). The
; nearest hit wins; of equal hits, the first in the scene wins, for any order of
; the regions. In a simple region the hit is tin if that is beyond the least
; distance, else tout. The crossings of a tree are collected (nodes_scalar.s)
; and searched by VISIBLE, slightly farther than the nearest hit so far, because
; another may be equally near. Regions that the ray does not come near cost only
; the test.
;
; With KEYS the least key wins: a distance plus P_TIE_OFFSET times k_delta.
; w_limit is the least key so far, w_depth the distance of that hit. With
; INTERIORS a ray that has passed a clear surface hits regions of a lower rank
; from -k_delta on (docs/solids.md).
;
; The parameters of a hit on a patch are stored in the primitive's
; P_PATCH_POINT. In a tree they are those of the first crossing within delta of
; the distance.

        .share  local
        .if     KEYS
        .regs   r89, w_passed, w_depth
        .if     HIDDEN
        .reg    w_class, r91
        .endif
        .else
        .if     HIDDEN
        .reg    w_class, r89
        .endif
        .endif
        .endshare
        .equ    NEAREST_REGISTERS, WALK_REGISTERS + 2 * KEYS + HIDDEN
        .equ    NEAREST_ARGUMENTS, 2 + HIDDEN

        .data
nearest_save:   .space NEAREST_REGISTERS
segment:        .space 2
kernel_list:    .descriptor 6, 0
kernel_primitive: .word 0
                .descriptor 2, segment
        .code

        .macro  enter_walk save, registers, number
        store_words w_ray, \registers, \save, save_at
        load_word bound_less, w_less
        RTOR    link, w_link
        load_from arguments, \number, w_ray
        RTOR    w_ray, w_at
        load_from w_at, 7, w_ox
        store_word w_ray, kernel_list, w_at
        store_word r0, local_space, w_at
        load_words scene_regions, 2, w_region, w_at
        enter_hierarchy
        .endm

        .macro  leave_walk save, registers
        RTOR    w_link, link
        leave   \save, \registers
        .endm

; Branches to `again` for the next region while there is one.
        .macro  next_region again
        IX      w_region, 64 * R_SIZE
        IBXNE   w_regions_left, m_index_minus_one, r0, \again, w_regions_left
        .endm

        .macro  load_region
        RTOR    w_region, w_at
        load_from w_at, REGION_LOADED, w_cx
        .endm

; Sets w_in to the hit in a simple region. Branches to `near` if it is before
; the limit, to `miss` if there is none.
        .macro  intersect_simple near, miss
        store_word w_first, kernel_primitive, w_at
        load_from w_first, 2, target            ; target, inner
        EX      arguments, kernel_list
        BSAVE   link, [target]
        load_words segment, 2, w_in, w_at
        .endkernel
        .kernel visible
        CFPLT   w_lower, w_in, simple_ahead\@
        RTOR    w_out, w_in
        CFPGE   w_lower, w_in, \miss
simple_ahead\@:
        CFPLT   w_in, w_limit, \near
        .endm

; Stores the parameters of the crossing at w_in on w_leaf (and w_out), in a
; tree, in its P_PATCH_POINT, if it is a patch or a mesh. Then branches to
; `done`.
        .macro  store_point done
        load_of w_out, P_ON_PATCH, w_t0
        IBXEQ   w_t0, r0, r0, \done
        IX      w_out, 64 * P_FIRST_EVENT
        LOD     [w_out], w_t1
        RTOR    w_leaf, w_at
        .if     MESH_CROSSINGS
        SHIFTI  w_t0, -1, w_t2
        IBXEQ   w_t2, r0, m_index_one, point_triangle\@
        .endif
        IX      w_at, 64 * (P_PATCH_POINTS - 2)
        load_word k_delta, w_t2
        SUBN    w_in, w_t2, w_t3
        ADDN    w_in, w_t2, w_t4
point_crossing\@:
        LOD     [w_t1], w_t2
        IX      w_t1, 64
        IX      w_at, 64 * 2
        CFPLT   w_t2, w_t3, point_crossing\@
        CFPLT   w_t4, w_t2, point_crossing\@
        load_from w_at, 2, w_t0                 ; w_t0, w_t1
        store_part w_t0, 2, w_leaf, P_PATCH_POINT, w_at
        BIM     \done

        .if     MESH_CROSSINGS
; Stores the triangle of a mesh, and 1 if the ray leaves there. Every second
; crossing leaves a solid.
point_triangle\@:
        address_of w_leaf, P_SHAPE + 1, w_at
        LOD     [w_at], w_t5
        FLR     w_t5, w_t5                      ; offset of the triangles
        IX      w_at, 64 * (P_SEGMENTS - P_SHAPE - 1)
        LOD     [w_at], w_t6
        ES      w_t2, 2
        IBXEQ   w_t0, r0, w_t2, point_sided\@
        RTOR    r0, w_t6                        ; its normals show the side
point_sided\@:
        load_word k_delta, w_t2
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
        store_part w_t0, 2, w_leaf, P_PATCH_POINT, w_at
        BIM     \done
        .endif
        .endm

; Sets w_t0 to the key of a hit at w_in on the primitive.
        .macro  count_hit primitive
        load_of \primitive, P_TIE_OFFSET, w_t0
        load_word k_delta, w_t1
        MPYS    w_t0, w_t1, w_t0
        ADDN    w_in, w_t0, w_t0
        .endm

        .kernel visible
nearest:
        enter_walk nearest_save, NEAREST_REGISTERS, NEAREST_ARGUMENTS
        .if     HIDDEN
        LOD     [w_result_at], w_class
        .endif
        load_word k_far, w_limit
        .if     KEYS
        RTOR    w_limit, w_depth
        .endif
        .if     INTERIORS
        ES      w_at, 8
        LOD     [w_ray, w_at], w_passed
        .endif
        ES      w_leaf, 0
        IBXEQ   w_regions_left, r0, r0, nearest_leaf
        .endkernel
        .kernel bound
nearest_region:
        load_region
        .if     HIDDEN
        load_of w_region, R_HIDDEN_FROM, w_t0
        AND     w_t0, w_class, w_t0
        IBXNE   w_t0, r0, r0, nearest_skip
        .endif
        skip_far w_cx, w_cy, w_cz, w_radius, w_square, w_limit, nearest_skip
        .if     INTERIORS
        IBXNE   w_passed, r0, r0, nearest_passed
nearest_least:
        .endif
        .endkernel
        .kernel call
        IBXNE   w_flags, r0, m_index_one, nearest_other
nearest_simple:
        intersect_simple nearest_near, nearest_skip
        CFPNE   w_in, w_limit, nearest_skip
        .if     SIMPLE_YIELDS
nearest_near:
        count_hit w_first
        CFPLT   w_t0, w_limit, nearest_hit
        CFPNE   w_t0, w_limit, nearest_skip
        IBXGE   w_first, r0, w_leaf, nearest_skip
nearest_hit:
        RTOR    w_t0, w_limit
        .else
        IBXGE   w_first, r0, w_leaf, nearest_skip
nearest_near:
        RTOR    w_in, w_limit
        .endif
        RTOR    w_first, w_leaf
        .if     KEYS
        RTOR    w_in, w_depth
        .endif
        .endkernel
        .kernel bound
nearest_skip:
        next_region nearest_region
nearest_leaf:
        next_leaf nearest_region, nearest_done
        .endkernel
        .kernel visible
nearest_done:
        .if     KEYS
        RTOR    w_depth, w_limit
        .endif
        SWAP    [r0], w_limit, [w_argument]
        leave_walk nearest_save, NEAREST_REGISTERS
        .endkernel
        .kernel bound
nearest_other:
        test_box nearest_tree, nearest_simple, nearest_skip
        .endkernel
        .kernel visible
nearest_tree:
        load_word bound_more, w_end
        MPYS    w_limit, w_end, w_end
        .if     KEYS
        load_word k_delta, w_t0
        ADDN    w_end, w_t0, w_end
        .endif
        call_routine intersect_tree, w_back
        IBXEQ   w_hit, r0, r0, nearest_skip
        next_visible w_least, nearest_skip
        .if     KEYS
        count_hit w_out
        CFPLT   w_t0, w_limit, nearest_visible
        CFPNE   w_t0, w_limit, nearest_skip
        .else
        CFPLT   w_in, w_limit, nearest_visible
        CFPNE   w_in, w_limit, nearest_skip
        .endif
        IBXGE   w_out, r0, w_leaf, nearest_skip
nearest_visible:
        .if     KEYS
        RTOR    w_in, w_depth
        RTOR    w_t0, w_limit
        .else
        RTOR    w_in, w_limit
        .endif
        RTOR    w_out, w_leaf
        store_point nearest_skip

        .if     INTERIORS
; The ray passed a clear surface. It hits regions of a lower rank at its start.
nearest_passed:
        load_of w_first, P_RANK, w_t0
        load_word k_lower, w_t1
        RTOR    m_tmin, w_lower
        IBXGE   w_t0, r0, w_passed, nearest_lowered
        load_word k_delta, w_t2
        SUBN    r0, w_t2, w_t1
        RTOR    w_t1, w_lower
nearest_lowered:
        address_of w_ray, 6, w_at
        STO     [w_at], w_lower
        STO     [w_at, m_index_one], w_t1
        store_word r0, local_space, w_at
        BIM     nearest_least
        .endif
        .endkernel
