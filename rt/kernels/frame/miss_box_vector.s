; miss_box_vector.s - selects the rays that come near the box of a region.
;
; The bounding sphere of a long or flat object is mostly empty. The box is
; aligned with the world's axes, with centre C and half sides H. Let L = C - O.
; The line along D hits the box if it passes no edge on the outer side:
;
;   |L_y D_z - L_z D_y| <= H_y |D_z| + H_z |D_y|,  also for z, x and x, y
;
; H is enlarged by |L| / 2^40, which exceeds the rounding error of the products.
; The host has enlarged the box by the error of the kernels. The test applies to
; the whole line. Only the sphere test (bound_vector.s) excludes objects before
; the start or after the limit of a ray. Rays with one origin, or towards one
; point light, have L in common.
;
; In:  region; the near current rays: wox .. wdz, near_limit, ray_index.
; Out: the same for the rays that come near the box, s6 of them.
; Source: separating axes of a line and a box: Gottschalk, Lin and Manocha 1996.

        .share  scratch
        .regs   r233, box_x, box_y, box_z, box_hx, box_hy, box_hz, box_lost
        .endshare

; Products and sums are linked if L and H are in registers. With vectors, a link
; would read three.
        .macro  separating_axis c1, c2, d1, d2, h1, h2, a1, a2, bits, vectors
        MPYSV   \c1, [\d2], [w9]
        MPYSV   \h1, [\a2], [w11]
        .if     !\vectors
        LINKV
        .endif
        MPYSV   \c2, [\d1], [w10]
        SUBNV   [w9], [w10], [w9]
        .if     !\vectors
        LINKV
        .endif
        MPYSV   \h2, [\a1], [w10]
        ADDNV   [w11], [w10], [w11]
        ABSV    [w9], [w9]
        CMPGEV  [w11], [w9], [\bits]
        .endm

        .macro  separating_next
        ANDB    [near_bits], [bits0], [near_bits]
        if_none near_bits, s6, box_taken
        .endm

        .macro  separating_axes x, y, z, hx, hy, hz, vectors
        separating_axis \y, \z, wdy, wdz, \hy, \hz, w1, w2, near_bits, \vectors
        if_none near_bits, s6, box_taken
        separating_axis \z, \x, wdz, wdx, \hz, \hx, w2, w0, bits0, \vectors
        separating_next
        separating_axis \x, \y, wdx, wdy, \hx, \hy, w0, w1, bits0, \vectors
        separating_next
        .endm

        .macro  box_from_point c, p, h, work
        SUBN    \c, \p, \c
        ABS     \c, \work
        MPYS    \work, box_lost, \work
        ADDN    \h, \work, \h
        .endm

        .macro  box_from_origins c, o, h, away, size
        SUBNV   \c, [\o], [\away]
        ABSV    [\away], [\size]
        LINKV
        MPYSV   [\size], box_lost, [\size]
        ADDNV   [\size], \h, [\size]
        .endm

        .kernel bound
take_box_hits:
        load_part region, R_BOX, 6, box_x, s0
        load_word bound_lost, box_lost
        describe near_bits, queue_bits, near
        ABSV    [wdx], [w0]
        ABSV    [wdy], [w1]
        ABSV    [wdz], [w2]
        RTOR    shadows, s0
        if_to_point box_of_point, s1
        EX      s0, queue_origin
        IBXNE   from_one_point, r0, r0, box_of_point
        box_from_origins box_x, wox, box_hx, w3, w6
        box_from_origins box_y, woy, box_hy, w4, w7
        box_from_origins box_z, woz, box_hz, w5, w8
        separating_axes [w3], [w4], [w5], [w6], [w7], [w8], 1
        BIM     box_tested
box_of_point:
        load_from s0, 3, s3
        box_from_point box_x, s3, box_hx, s7
        box_from_point box_y, s4, box_hy, s8
        box_from_point box_z, s5, box_hz, s9
        separating_axes box_x, box_y, box_z, box_hx, box_hy, box_hz, 0
box_tested:
        if_sparse  s6, near, box_sparse
box_taken:
        BIM     0, link_inner

box_sparse:
        set_near s6
        leave_only ray_index, ray_index_store, 0, near_bits
        leave_only near_limit, ray_index_store, 1, near_bits
        leave_only wdx, world_store, 3, near_bits
        leave_only wdy, world_store, 4, near_bits
        leave_only wdz, world_store, 5, near_bits
        IBXNE   from_one_point, r0, r0, take_origin
        leave_only wox, world_store, 0, near_bits
        leave_only woy, world_store, 1, near_bits
        leave_only woz, world_store, 2, near_bits
        BIM     take_least
        .endkernel
