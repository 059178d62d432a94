; queue.s - the ray queue and the vector program's use of registers.
;
; A queue holds QUEUE rays (2,000 in the paper). Each quantity of a ray is a
; vector over the queue. Vectors have one of these lengths:
;
;   n     rays of the queue
;   near  current rays: those that come near the current region
;   h, m  all hits; hits of one primitive; lanes of a kernel
;
; The descriptors of the vectors stay in registers. For vectors of equal length,
; a table holds their addresses with length zero. One vector OR inserts the new
; length into the whole table and one SWAP loads it, so two instructions set all
; lengths.
;
; The vector program calls its routines by BSAVE, with all arguments in
; registers. There are three levels of kernels, each with its own link register.
; The callers of kernels have links of their own.
;
; Routines that share registers declare this by .share with a name:
;
;   shape      data of the current shape, node or region; each user loads its
;              own
;   crossings  results of a kernel until they are stored among the crossings of
;              a tree; then used by the code that reads these
;   hits       vectors of the hits that are shaded, of a kernel's lanes, or of
;              the values of a tree; each user loads its descriptors first
;   phase      used by intersection, then by shading, which keeps nothing there
;              while shadow rays are traced
;   scratch    temporaries of routines that do not call each other

        .include "frame/common.s"

        .regs   r1, link, link_kernel, link_inner
        .reg    n, r4              ; rays in the queue, an integer
        .reg    near, r5           ; current rays
        .regs   r6, s0, s1, s2, s3, s4, s5, s6, s7, s8, s9    ; scratch
        .regs   r16, one, half, two, big, minus_big, tiny, tmin, checker_shift
        .regs   r24, level, position, h   ; level; position in its list; hits
        .regs   r28, primitive, leaf_at, shape_at
        .regs   r31, target, inner_kernel
        .regs   r34, light_at, lights_left
        .regs   r36, region, regions_left, node_at, nodes_end

; Shape parameters and matrix of the current primitive (records.s).
        .share  shape
        .regs   r40, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10
        .regs   r51, sh11, sh12, sh13, sh14, sh15
        .regs   r56, m00, m01, m02, m03, m10, m11, m12, m13, m20, m21, m22, m23
        .endshare

; Queue vectors, n long: the nearest hit so far or another limit of the ray; the
; number of the primitive hit (0: none); parameters of hits on patches; the
; rays; the bits of the rays that come near a region.
        .regs   r70, nearest, nearest_primitive, hit_s, hit_t
        .regs   r170, aox, aoy, aoz, adx, ady, adz
        .reg    near_bits, r112
        .reg    from_one_point, r193    ; 1: all rays have one origin
        .reg    shadows, r254           ; address of the target light, or 0
        .reg    found, r255             ; routine that receives the hits

; Current rays, near long: positions in the queue (unused if all rays of the
; queue are current), limits, origins, directions, least distances.
        .regs   r74, ray_index, near_limit
        .regs   r176, wox, woy, woz, wdx, wdy, wdz, wlower
        .share  phase
        .reg    space, r189             ; space of lox .., or 0
        .endshare

; Other vectors, near long, in the order of near_bases.
        .regs   r80, lox, loy, loz, ldx, ldy, ldz, lscale ; rays in object space
        .reg    llower, r87
        .regs   r88, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11
        .regs   r100, patch_s, patch_t                    ; of the kernel
        .equ    PATCH_VECTORS, 20                         ; before patch_s
        .regs   r102, bits0, bits1, bits2                 ; bit vectors
        .equ    NEAR_VECTORS, 25

; Results of a kernel: segments, the nearest first.
        .share  crossings
        .regs   r105, tin, tout, tin2, tout2, tin3, tout3
        .endshare
        .reg    segments_wanted, r199
        .reg    iota, r111                                ; 0, 1, 2, ...

; Rays that a kernel intersects, in world or object space.
        .regs   r116, ox, oy, oz, dx, dy, dz, lower

        .macro  set_rays x0, x1, x2, d0, d1, d2, least
        copy_three \x0, \x1, \x2, ox, oy, oz
        copy_three \d0, \d1, \d2, dx, dy, dz
        RTOR    \least, lower
        .endm

; Destination of the colours, n long, starting at the first ray of the queue.
; For the first level it includes the other planes of the frame.
        .regs   r124, out_red, out_green, out_blue, out_depth, out_nx, out_ny
        .regs   r130, out_nz, out_id

; The integers 1 and -1, for counting, and the number -1.
        .regs   r183, one_index, minus_one_index
        .reg    minus_one, r192
        .regs   r194, identity, on_patch

; Vectors for shading, h or m long, in the order of shade_bases. Kernels use
; these registers for their lanes, so shading loads them again.
        .share  hits
        .reg    m, r134
        .reg    m_high, r135
        .regs   r136, at                                  ; places in the queue
        .regs   r137, px, py, pz, hdx, hdy, hdz           ; point, direction
        .regs   r143, nx, ny, nz                          ; normal
        .regs   r146, cr, cg, cb                          ; pigment
        .regs   r149, red, green, blue                    ; light so far
        .regs   r152, lx, ly, lz                          ; towards the light
        .regs   r155, facing                              ; direction . normal
        .equ    HIT_VECTORS, 20
        .regs   r156, v0, v1, v2, v3, v4, v5, v6, v7
        .regs   r164, hits0, hits1, hits2, hits3        ; bit vectors
        .endshare
        .equ    SHADE_VECTORS, 32

        .equ    QUEUE_BIT_WORDS, (QUEUE + 63) / 64

        .data
near_bases:
        vector_bases NEAR_VECTORS - 3, near_store, 3, near_bit_store
near_descriptors:
        .space NEAR_VECTORS
near_bit_store: .space 3 * QUEUE_BIT_WORDS
queue_bits:     .space QUEUE_BIT_WORDS
        .if     INTERIORS
passed_bits:    .space QUEUE_BIT_WORDS
passed_current: .word 0                 ; 1: wlower is in passed_store, or, for
                                        ; few rays, in sparse_least; the one to be
                                        ; scaled follows QUEUE words later
queue_passed:   .word 0                 ; descriptor of the rank of the region
                                        ; whose clear surface each ray passed
                                        ; last (0: it comes from none); or 0: no
                                        ; ray comes from one
        .endif
        .align 64
near_store:     .space (NEAR_VECTORS - 3) * QUEUE
found_store:    .space 2 * QUEUE        ; tin, tout, if stored nowhere else
queue_store:    .space 10 * QUEUE       ; rays, nearest,
                                        ; nearest_primitive, hit_s, hit_t
ray_index_store: .space 2 * QUEUE       ; ray_index, near_limit
world_store:    .space 6 * QUEUE        ; wox ..
least_store:    .space QUEUE            ; QUEUE copies of tmin
least_shadow:   .space QUEUE            ; QUEUE copies of k_shadow
count_store:    .space QUEUE            ; 0, 1, 2, ...
        .if     INTERIORS
passed_store:   .space 3 * QUEUE        ; least distances; to be scaled; ranks
        .endif
        .if     KEYS
depth_store:    .space QUEUE            ; hit distances without P_TIE_OFFSET
        .endif
        .code

; Sets the length of the `number` descriptors of a table to `count`, an integer,
; and loads them into registers from `first` on.
        .macro  set_lengths count, high, bases, descriptors, number, first
        lengthen_table \bases, \descriptors, \number, \count, s0, s1, \high
        SWAP    [s1], \first, [r0]
        .endm

; Loads the constants for counting. No ray is current.
        .macro  begin_counting
        SUBN    r0, one, minus_one
        ES      one_index, 1
        ES      minus_one_index, -1
        ES      near, 0
        .endm

; Makes `count` rays current.
        .macro  set_near count
        IBXEQ   \count, r0, near, near_set\@
        RTOR    \count, near
        set_lengths near, s2, near_bases, near_descriptors, NEAR_VECTORS, lox
near_set\@:
        .endm

; Restores the default destination of patch_s and patch_t, for regions that do
; not use them.
        .macro  leave_parameters
        load_words near_descriptors + 64 * PATCH_VECTORS, 2, patch_s, s0
        .endm

; Makes descriptors of n words in each of three planes, whose distance is
; `stride`.
        .macro  three_planes first, stride, a, b, c
        ADDLEN  \first, n, \a
        ADDX    \a, \stride, \b
        ADDX    \b, \stride, \c
        .endm

; Makes the descriptors of the hits of the queue.
        .macro  set_hits_of_queue
        describe nearest, queue_store + 64 * QUEUE * 6, n
        describe nearest_primitive, queue_store + 64 * QUEUE * 7, n
        describe hit_s, queue_store + 64 * QUEUE * 8, n
        describe hit_t, queue_store + 64 * QUEUE * 9, n
        .endm

        .macro  add_to_counter label, count
        add_to_word \label, \count, s0, s1
        .endm

; [sum] = x . u for vectors x and a constant vector u in registers. Order of
; operations: (x1 u1 + x0 u0), then + x2 u2.
        .macro  dot_constant x0, x1, x2, u0, u1, u2, sum, work
        MPYSV   [\x0], \u0, [\sum]
        LINKV
        MPYSV   [\x1], \u1, [\work]
        ADDNV   [\work], [\sum], [\sum]
        LINKV
        MPYSV   [\x2], \u2, [\work]
        ADDNV   [\work], [\sum], [\sum]
        .endm

; [sum] = x . y for vectors.
        .macro  dot_vectors x0, x1, x2, y0, y1, y2, sum, work
        MPYSV   [\x0], [\y0], [\sum]
        MPYSV   [\x1], [\y1], [\work]
        ADDNV   [\work], [\sum], [\sum]
        MPYSV   [\x2], [\y2], [\work]
        ADDNV   [\work], [\sum], [\sum]
        .endm

; [c] = [a] x [b]
        .macro  cross_part a0, b1, a1, b0, c, work
        MPYSV   [\a1], [\b0], [\work]
        MPYSV   [\a0], [\b1], [\c]
        SUBNV   [\c], [\work], [\c]
        .endm

        .macro  cross a0, a1, a2, b0, b1, b2, c0, c1, c2, work
        cross_part \a1, \b2, \a2, \b1, \c0, \work
        cross_part \a2, \b0, \a0, \b2, \c1, \work
        cross_part \a0, \b1, \a1, \b0, \c2, \work
        .endm

; Computes the same with a constant vector b.
        .macro  cross_constant_part a0, b1, a1, b0, c, work
        MPYSV   [\a1], \b0, [\work]
        LINKV
        MPYSV   [\a0], \b1, [\c]
        SUBNV   [\c], [\work], [\c]
        .endm

        .macro  cross_constant a0, a1, a2, b0, b1, b2, c0, c1, c2, work
        cross_constant_part \a1, \b2, \a2, \b1, \c0, \work
        cross_constant_part \a2, \b0, \a0, \b2, \c1, \work
        cross_constant_part \a0, \b1, \a1, \b0, \c2, \work
        .endm

; Normalises the vector x0, x1, x2. [length] gets its length, [work] the
; reciprocal.
        .macro  normalise x0, x1, x2, length, work
        dot_vectors \x0, \x1, \x2, \x0, \x1, \x2, \length, \work
        SQRTV   [\length], [\length]
        DIVSV   one, [\length], [\work]
        three_by MPYSV, [\work], [\x0], [\x1], [\x2], [\x0], [\x1], [\x2]
        .endm

; Normalises the vector x0, x1, x2, whose length is nearly one. One Newton step
; for 1 / sqrt (X . X) from 1 gives X (1 + (1 - X . X) / 2). The remaining error
; is 3/8 of the square of the error of X . X.
        .macro  renormalise x0, x1, x2, scale, work
        dot_vectors \x0, \x1, \x2, \x0, \x1, \x2, \scale, \work
        SUBNV   one, [\scale], [\scale]
        LINKV
        MPYSV   [\scale], half, [\scale]
        ADDNV   [\scale], one, [\scale]
        three_by MPYSV, [\scale], [\x0], [\x1], [\x2], [\x0], [\x1], [\x2]
        .endm
