; bound_vector.s - selects the rays that come near a bounding sphere.
;
; With centre C, radius R, L = C - O:
;
;   b = L . D                         near:  L . L - b^2 <= R^2
;                                            b + R > 0,  b - R < limit
;
; The sphere is larger than its contents. L.L is reduced slightly to compensate
; for the rounding error of L.L - b^2 for small distant spheres, so no ray that
; hits is excluded. Rays with one origin have L and L.L in common. For them,
; spheres before the start (b + R <= 0) are left to the kernels. The rays of a
; queue towards a light P have L and L.L in common too, relative to P:
;
;   L = C - P,  b = L . D             near:  b < R,  limit + b + R > 0
;
; test_queue_bound is for rays of the queue under their own limits. test_bound
; is for other rays, whose limits may be nearer than the light. Spheres before
; the start of a ray are then left to the kernel.
;
; In:  ox .. dz, s8 = number of rays, s9 = descriptor of their limits; the
;      sphere in bound_x ..
; Out: near_bits, s8 long; s0 = the count of its ones.
; Source: derived here; the project's notes on ray tracing, 4.1.

        .share  shape
        .regs   r56, bound_x, bound_y, bound_z, bound_r, bound_r2
        .endshare
        .share  scratch
        .regs   r233, bound_g0, bound_g1, bound_g2, bound_g3, bound_bits
        .endshare

        .data
bound_bit_store: .space QUEUE_BIT_WORDS
queue_origin:   .space 3                ; the common origin, if there is one
        .align  64
bound_store:    .space 4 * QUEUE
        .code

        .macro  bound_axis center, o, d, product, square
        SUBNV   \center, [\o], [bound_g0]
        MPYSV   [bound_g0], [\d], [\product]
        MPYSV   [bound_g0], [bound_g0], [\square]
        .endm

; Makes the vectors of the test, s8 long.
        .macro  set_bound
        describe bound_g0, bound_store, s8
        address_of bound_g0, QUEUE, bound_g1
        address_of bound_g1, QUEUE, bound_g2
        address_of bound_g2, QUEUE, bound_g3
        describe bound_bits, bound_bit_store, s8
        describe near_bits, queue_bits, s8
        load_word bound_less, s7
        .endm

; Tests the sphere relative to the point at address s0, which all rays share.
        .macro  bound_common
        load_from s0, 3, s3
        three   SUBN, bound_x, bound_y, bound_z, s3, s4, s5, s3, s4, s5
        dot_constant dx, dy, dz, s3, s4, s5, bound_g1, bound_g0
        three   MPYS, s3, s4, s5, s3, s4, s5, s3, s4, s5
        ADDN    s3, s4, s3
        ADDN    s3, s5, s3
        MPYS    s3, s7, s3
        SUBN    s3, bound_r2, s3
        LINKV
        MPYSV   [bound_g1], [bound_g1], [bound_g0]
        CMPGEV  [bound_g0], s3, [near_bits]
        .endm

; Branches to `there` if all rays go to one point light.
        .macro  if_to_point there, work
        .if     BEAMS
        IBXEQ   shadows, r0, r0, not_to_point\@
        load_word shadow_parallel, \work
        IBXEQ   \work, r0, r0, \there
not_to_point\@:
        .else
        IBXNE   shadows, r0, r0, \there
        .endif
        .endm

        .kernel bound
test_queue_bound:
        if_to_point bound_to_light, s0
test_bound:
        if_to_point bound_line_to_light, s0
        set_bound
        IBXNE   from_one_point, r0, r0, bound_from_point
        bound_axis bound_x, ox, dx, bound_g1, bound_g2
        bound_axis bound_y, oy, dy, bound_g3, bound_g0
        ADDNV   [bound_g3], [bound_g1], [bound_g1]
        ADDNV   [bound_g0], [bound_g2], [bound_g2]
        bound_axis bound_z, oz, dz, bound_g3, bound_g0
        ADDNV   [bound_g3], [bound_g1], [bound_g1]
        ADDNV   [bound_g0], [bound_g2], [bound_g2]
        LINKV
        MPYSV   [bound_g2], s7, [bound_g2]
        SUBNV   [bound_g2], bound_r2, [bound_g2]
        MPYSV   [bound_g1], [bound_g1], [bound_g0]
        CMPGEV  [bound_g0], [bound_g2], [near_bits]
        if_none near_bits, s0, bound_tested
        SUBN    r0, bound_r, s6
        keep_where CMPLTV, s6, [bound_g1], near_bits, bound_bits
bound_range:
        SUBNV   [bound_g1], bound_r, [bound_g0]
        keep_where CMPLTV, [bound_g0], [s9], near_bits, bound_bits
        CNTOB   [near_bits], s0
bound_tested:
        BIM     0, link_inner

bound_from_point:
        EX      s0, queue_origin
        bound_common
        if_none near_bits, s0, bound_tested
        BIM     bound_range

bound_line_to_light:
        set_bound
        RTOR    shadows, s0
        bound_common
        keep_where CMPLTV, [bound_g1], bound_r, near_bits, bound_bits
        CNTOB   [near_bits], s0
        BIM     bound_tested

bound_to_light:
        set_bound
        RTOR    shadows, s0
        bound_common
        if_none near_bits, s0, bound_tested
        keep_where CMPLTV, [bound_g1], bound_r, near_bits, bound_bits
        load_word k_shadow, s0
        SUBN    r0, bound_r, s1
        SUBN    s1, s0, s1
        ADDNV   [bound_g1], [s9], [bound_g0]
        keep_where CMPLTV, s1, [bound_g0], near_bits, bound_bits
        CNTOB   [near_bits], s0
        BIM     bound_tested

; Makes all s8 rays of a set current: ox .. dz, their limits in s9.
take_all:
        set_near s8
        copy_three ox, oy, oz, wox, woy, woz
        copy_three dx, dy, dz, wdx, wdy, wdz
        RTOR    s9, near_limit
        load_word walk_set, s1
        IX      s1, 64 * SET_INDEX
        LOD     [s1], ray_index
        BIM     take_least

; Gathering is faster than compressing if 4 count + GATHER_LESS is below all.
        .equ    GATHER_LESS, 64

        .macro  if_gather_pays count, all, work, few
        ADDX    \count, \count, \work
        ADDX    \work, \work, \work
        IX      \work, GATHER_LESS
        IBXLT   \work, r0, \all, \few
        .endm

; Compresses a vector to the s6 rays of near_bits.
        .macro  take_near vector, into, store, number
        EX      \into, \store + 64 * QUEUE * \number
        CPSV    [\vector], [\into] ? [near_bits]
        .endm

; Compresses `vector` to the rays of `bits`, and makes the result the new
; `vector`.
        .macro  leave_only vector, store, number, bits
        EX      s3, \store + 64 * QUEUE * \number
        CPSV    [\vector], [s3] ? [\bits]
        RTOR    s3, \vector
        .endm

; Makes descriptors of `count` elements from those of `all` elements of three
; vectors, whose names begin with `from` and `into`. These have equal elements.
        .macro  change_length from, into, count, all, work
        SUBX    \count, \all, \work
        ADDLEN  \from\()x, \work, \into\()x
        ADDLEN  \from\()y, \work, \into\()y
        ADDLEN  \from\()z, \work, \into\()z
        .endm

        .macro  gather_near vector, into, store, number
        describe \into, \store + 64 * QUEUE * \number, near
        VXTOV   [ray_index], [\vector], [\into]
        .endm

take_some:
        set_near s6
        load_word walk_set, s1
        IX      s1, 64 * SET_INDEX
        LOD     [s1], s3
        take_near s3, ray_index, ray_index_store, 0
        if_gather_pays near, s8, s0, take_sparse
        take_near s9, near_limit, ray_index_store, 1
        take_near dx, wdx, world_store, 3
        take_near dy, wdy, world_store, 4
        take_near dz, wdz, world_store, 5
        IBXNE   from_one_point, r0, r0, take_origin
        take_near ox, wox, world_store, 0
        take_near oy, woy, world_store, 1
        take_near oz, woz, world_store, 2
        BIM     take_least

; Gathers few rays from the queue.
take_sparse:
        gather_near nearest, near_limit, ray_index_store, 1
        gather_near adx, wdx, world_store, 3
        gather_near ady, wdy, world_store, 4
        gather_near adz, wdz, world_store, 5
        IBXNE   from_one_point, r0, r0, take_origin
        gather_near aox, wox, world_store, 0
        gather_near aoy, woy, world_store, 1
        gather_near aoz, woz, world_store, 2
        BIM     take_least
take_origin:
        change_length ao, wo, near, n, s9
take_least:
        ES      space, 0
take_lower:
        EX      wlower, least_store
        .if     INTERIORS
        store_word r0, passed_current, s0
        IBXNE   shadows, r0, r0, take_shadow
        load_word queue_passed, s3
        IBXNE   s3, r0, r0, take_passed
        BIM     take_lengthen
take_shadow:
        .else
        IBXEQ   shadows, r0, r0, take_lengthen
        .endif
        EX      wlower, least_shadow
take_lengthen:
        ADDLEN  wlower, near, wlower
        BIM     0, link_inner

        .if     INTERIORS
; Rays that passed a clear surface of a later region also hit this region at
; their start.
take_passed:
        load_of region, R_FIRST, s0
        IX      s0, 64 * P_RANK
        LOD     [s0], s0
        describe s1, passed_store + 64 * QUEUE * 2, near
        describe s2, passed_bits, near
        VXTOV   [ray_index], [s3], [s1]
        CMPGEV  s0, [s1], [s2]
        CNTOB   [s2], s3
        IBXEQ   s3, r0, near, take_lengthen
        load_word k_delta, s0
        SUBN    r0, s0, s0
        load_word k_lower, s1
        describe wlower, passed_store, near
        MASKV   tmin, s0, [wlower] ? [s2]
        describe s3, passed_store + 64 * QUEUE, near
        MASKV   s1, s0, [s3] ? [s2]
        store_word one_index, passed_current, s0
        BIM     0, link_inner
        .endif
        .endkernel
