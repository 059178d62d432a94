; queue.s - the ray queue, and how the vector program uses the registers.
;
; A queue holds QUEUE rays (2,000 in the paper); each quantity of a ray is a
; vector.  There are vectors of three lengths:
;
;   n     the rays of the queue
;   near  the rays at hand, which come near the region that is looked at
;   h, m  what was hit: all of it, the part of one primitive; lanes of a kernel
;
; The vectors' descriptors stay in registers.  Where many have one length their
; addresses stand in a table with length zero; one vector OR puts the new length
; into the whole table and one SWAP loads it: 2 instructions for all of them.
;
; The vector program calls its routines by BSAVE with everything in registers.
; Three levels of kernels, each with its link register; what calls those has
; links of its own.
;
; Who shares registers with others says so (.share), and under what word:
;
;   shape      what is loaded of the shape, the node or the region that is
;              looked at; whoever looks at the next one loads its own
;   crossings  what a kernel finds, until it is put among the crossings of a
;              tree; then of those who look at these
;   hits       vectors of the hits that are shaded, of a kernel's lanes, of the
;              values of a tree: each loads its descriptors when it begins
;   phase      of those who look for what is hit, then of those who shade it,
;              who have nothing there while shadows are looked for
;   scratch    a routine's own, of those that do not call one another

        .regs   r1, link, link_kernel, link_inner
        .reg    n, r4              ; rays in the queue, an integer
        .reg    near, r5           ; rays at hand
        .regs   r6, s0, s1, s2, s3, s4, s5, s6, s7, s8, s9    ; scratch
        .regs   r16, one, half, two, big, minus_big, tiny, tmin, checker_shift
        .regs   r24, level, position, h   ; of reflection; in its rays
        .regs   r28, primitive, leaf_at, shape_at
        .regs   r31, target, inner_kernel
        .regs   r34, light_at, lights_left
        .regs   r36, region, regions_left, node_at, nodes_end

; Shape parameters and the matrix of the primitive at hand (see records.s).
        .share  shape
        .regs   r40, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10
        .regs   r51, sh11, sh12, sh13, sh14, sh15
        .regs   r56, m00, m01, m02, m03, m10, m11, m12, m13, m20, m21, m22, m23
        .endshare

; Queue vectors, n long: the rays, the nearest hit so far or what else limits a
; ray, the number of the primitive hit (0: none), parameters of hits on patches,
; which rays come near a region.
        .regs   r70, nearest, met, hit_s, hit_t
        .regs   r170, aox, aoy, aoz, adx, ady, adz
        .reg    near_bits, r112
        .reg    from_one_point, r193    ; 1: all rays start at one point
        .reg    shadows, r254           ; address of the light they go to, or 0
        .reg    found, r255             ; the routine that takes what they hit

; The rays at hand, near long: their limits, their places in the queue (not
; when they are all of it), origins and directions, least distances.
        .regs   r74, place, near_limit
        .regs   r176, wox, woy, woz, wdx, wdy, wdz, wlower
        .share  phase
        .reg    space, r189             ; the space in which lox .. stand, or 0
        .endshare

; Other vectors near long; the order of near_bases.
        .regs   r80, lox, loy, loz, ldx, ldy, ldz, lscale ; rays, own space
        .reg    llower, r87
        .regs   r88, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11
        .regs   r100, patch_s, patch_t                    ; of the kernel
        .equ    PATCH_VECTORS, 20                         ; before them
        .regs   r102, bits0, bits1, bits2                 ; bit vectors
        .equ    NEAR_VECTORS, 25

; What a kernel finds: segments, the nearest first.
        .share  crossings
        .regs   r105, tin, tout, tin2, tout2, tin3, tout3
        .endshare
        .reg    segments_wanted, r199
        .reg    iota, r111                                ; 0, 1, 2, ...

; The ray that a kernel looks at: world or own space.
        .regs   r116, ox, oy, oz, dx, dy, dz, lower

        .macro  look_at_rays x0, x1, x2, d0, d1, d2, least
        RTOR    \x0, ox
        RTOR    \x1, oy
        RTOR    \x2, oz
        RTOR    \d0, dx
        RTOR    \d1, dy
        RTOR    \d2, dz
        RTOR    \least, lower
        .endm

; Where the colours go, from the queue's first ray on, n long; of the first
; level also the frame's other planes.
        .regs   r124, out_red, out_green, out_blue, out_depth, out_nx, out_ny
        .regs   r130, out_nz, out_id

; The integers 1 and -1, for counting, and the number -1.
        .regs   r183, one_index, minus_one_index
        .reg    minus_one, r192
        .regs   r194, identity, on_patch

; Vectors for shading, h or m long; the order of shade_bases.  Kernels have
; lanes in these registers; who shades loads them again.
        .share  hits
        .reg    m, r134
        .reg    m_high, r135
        .regs   r136, at                                  ; their places in n
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

; A table of vectors without length, and of bit vectors behind them.
        .macro  vector_bases vectors, store, bits, bit_store
        .rept   \vectors
        .descriptor 0, \store + 64 * QUEUE * \+
        .endr
        .rept   \bits
        .descriptor 0, \bit_store + 64 * QUEUE_BIT_WORDS * \+
        .endr
        .endm

        .data
near_bases:
        vector_bases NEAR_VECTORS - 3, near_store, 3, near_bit_store
near_descriptors:
        .space NEAR_VECTORS
near_bit_store: .space 3 * QUEUE_BIT_WORDS
queue_bits:     .space QUEUE_BIT_WORDS
        .if     INTERIORS
passed_bits:    .space QUEUE_BIT_WORDS
passed_at_hand: .word 0                 ; 1: wlower stands in passed_store, or with few
                                ; rays in few_least; the same to be scaled QUEUE
                                ; words behind it
queue_passed:   .word 0                 ; descriptor: the rank of the region whose clear
                                ; surface each ray has passed last, 0: it comes
                                ; from none; or 0: none does
        .endif
        .align 64
near_store:     .space (NEAR_VECTORS - 3) * QUEUE
found_store:    .space 2 * QUEUE        ; tin, tout, where they go nowhere else
queue_store:    .space 10 * QUEUE       ; rays, nearest, met, hit_s, hit_t
place_store:    .space 2 * QUEUE        ; place, near_limit
world_store:    .space 6 * QUEUE        ; wox ..
least_store:    .space QUEUE            ; as many times tmin
least_shadow:   .space QUEUE            ; k_shadow
count_store:    .space QUEUE            ; 0, 1, 2, ...
        .if     INTERIORS
passed_store:   .space 3 * QUEUE        ; least distances, to be scaled; ranks
        .endif
        .if     KEYS
depth_store:    .space QUEUE            ; distances of the nearest hits, without P_YIELD
        .endif
        .code

; A descriptor of count elements.
        .macro  describe register, address, count
        EX      \register, \address
        ADDLEN  \register, \count, \register
        .endm

; All descriptors of a table become count (an integer) long: number registers
; from first on.
        .macro  set_lengths count, high, bases, descriptors, number, first
        SHIFTI  \count, 48, \high
        EX      s0, \bases
        ELEN    s0, \number
        EX      s1, \descriptors
        ELEN    s1, \number
        ORV     [s0], \high, [s1]
        SWAP    [s1], \first, [r0]
        .endm

; What is counted with; one is loaded, and no ray is at hand.
        .macro  begin_counting
        SUBN    r0, one, minus_one
        ES      one_index, 1
        ES      minus_one_index, -1
        ES      near, 0
        .endm

; There are count rays at hand.
        .macro  set_near count
        IBXEQ   \count, r0, near, near_set\@
        RTOR    \count, near
        set_lengths near, s2, near_bases, near_descriptors, NEAR_VECTORS, lox
near_set\@:
        .endm

; patch_s and patch_t are again where they go if no region wants them.
        .macro  leave_parameters
        EX      s0, near_descriptors + 64 * PATCH_VECTORS
        ELEN    s0, 2
        SWAP    [s0], patch_s, [r0]                       ; and patch_t
        .endm

; Load number words at offset of the primitive's record into registers.
        .macro  load_record offset, number, first
        RTOR    primitive, shape_at
        IX      shape_at, 64 * (\offset)
        ELEN    shape_at, \number
        SWAP    [shape_at], \first, [r0]
        .endm

        .macro  load_field offset, register
        RTOR    primitive, shape_at
        IX      shape_at, 64 * (\offset)
        LOD     [shape_at], \register
        .endm

        .macro  store_field offset, register
        RTOR    primitive, shape_at
        IX      shape_at, 64 * (\offset)
        STO     [shape_at], \register
        .endm

; Three planes, apart by a stride: the n words of the queue, of each from first on.
        .macro  three_planes first, stride, a, b, c
        ADDLEN  \first, n, \a
        ADDX    \a, \stride, \b
        ADDX    \b, \stride, \c
        .endm

; What the rays of the queue hit.
        .macro  set_hits_of_queue
        describe nearest, queue_store + 64 * QUEUE * 6, n
        describe met, queue_store + 64 * QUEUE * 7, n
        describe hit_s, queue_store + 64 * QUEUE * 8, n
        describe hit_t, queue_store + 64 * QUEUE * 9, n
        .endm

; A word of the program's data.
        .macro  load_word label, register
        EX      \register, \label
        LOD     [\register], \register
        .endm

        .macro  add_to_counter label, count
        EX      s0, \label
        LOD     [s0], s1
        ADDX    s1, \count, s1
        STO     [s0], s1
        .endm

; [sum] = x . u for vectors x and a vector constant u in registers.
; Order of operations: (x1 u1 + x0 u0), then + x2 u2.
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

; The same with a vector constant b.
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

; Divide x0, x1, x2 by the length of the vector they make.  [length] gets that
; length, [work] its reciprocal.
        .macro  normalise x0, x1, x2, length, work
        dot_vectors \x0, \x1, \x2, \x0, \x1, \x2, \length, \work
        SQRTV   [\length], [\length]
        DIVSV   one, [\length], [\work]
        MPYSV   [\x0], [\work], [\x0]
        MPYSV   [\x1], [\work], [\x1]
        MPYSV   [\x2], [\work], [\x2]
        .endm

; Make the vector x0, x1, x2 of length one that all but is: a step of Newton's
; for 1 / sqrt (X . X) from 1, X (1 + (1 - X . X) / 2), leaves 3/8 of the square
; of what X . X is off by.
        .macro  renormalise x0, x1, x2, scale, work
        dot_vectors \x0, \x1, \x2, \x0, \x1, \x2, \scale, \work
        SUBNV   one, [\scale], [\scale]
        LINKV
        MPYSV   [\scale], half, [\scale]
        ADDNV   [\scale], one, [\scale]
        MPYSV   [\x0], [\scale], [\x0]
        MPYSV   [\x1], [\scale], [\x1]
        MPYSV   [\x2], [\scale], [\x2]
        .endm
