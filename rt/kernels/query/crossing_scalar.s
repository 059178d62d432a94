; crossing_scalar.s - computes the direction and the normal of a visible
; crossing.

        .data
normal_save:    .space SHADE_REGISTERS
normal_list:    .word 0                         ; ray
normal_primitive: .word 0
                .descriptor 1, normal_distance
                .descriptor 3, normal_found
normal_distance: .space 1
normal_found:   .space 3
        .code

; Sets c_distance, c_primitive and w_leaf for the crossing w_in on w_out. Sets
; c_crossing to 1 where the ray enters the body of the region, to -1 where it
; leaves, and to 0 if there is no body. The value of the region's tree after the
; crossing decides.
        .macro  find_crossing
        RTOR    w_in, c_distance
        RTOR    w_out, w_leaf
        load_of w_out, P_ID, c_primitive
        address_of w_region, R_BODY, w_at
        LOD     [w_at], c_crossing
        IX      w_at, 64 * (R_RESULT - R_BODY)
        LOD     [w_at], w_t0
        LOD     [w_t0], w_t0
        AND     w_t0, m_index_one, w_t0         ; the value after the crossing
        IBXNE   w_t0, r0, r0, crossing_found\@
        SUBX    r0, c_crossing, c_crossing
crossing_found\@:
        .endm

        .macro  find_normal_at ray
        EX      w_at, normal_list
        STO     [w_at], \ray
        STO     [w_at, m_index_one], w_leaf
        store_word c_distance, normal_distance
        call    normal_at_hit, normal_list
        load_words normal_found, 3, c_nx
        .endm

;       CALL NORMAL_THERE (RAY, PRIMITIVE, DISTANCE, NORMAL)
;
; RAY = O, D (6 words). PRIMITIVE = the record of the primitive that it hit.
; DISTANCE (1). NORMAL = of length one, against the ray (3).
        .kernel shade
normal_at_hit:
        store_words r32, SHADE_REGISTERS, normal_save
        RTOR    link, link_saved
        load_from arguments, 4, a_ray
        load_from a_ray, 6, ox
        LOD     [a_distance], t0
        find_surface
        SWAP    [r0], nx, [a_sample]
        RTOR    link_saved, link
        leave   normal_save, SHADE_REGISTERS
        .endkernel
