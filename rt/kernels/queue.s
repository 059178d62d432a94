; queue.s - the ray queue, and how the vector program uses the registers.
;
; A queue holds QUEUE rays (2,000 in the paper); each quantity of a ray is a
; vector of that length.  The vectors' descriptors stay in registers.  Their
; addresses stand in a table with length zero; when a queue is shorter than
; the last one, one vector OR puts the new length into the whole table and one
; SWAP loads it: 2 instructions for all descriptors.
;
; The vector program calls its routines by BSAVE with everything in registers.
; Three levels, each with its link register.

        .regs   r1, link, link_kernel, link_inner
        .reg    n, r4              ; rays in the queue, an integer
        .reg    n_high, r5         ; the same in the length field, address zero
        .regs   r6, s0, s1, s2, s3, s4, s5, s6, s7, s8, s9    ; scratch
        .regs   r16, one, half, two, big, minus_big, tiny, tmin, checker_shift
        .regs   r24, pixel, pixels, batch
        .regs   r28, primitive, primitives_left, shape_at, target
        .regs   r32, identity, on_patch
        .regs   r34, light_at, lights_left

; Shape parameters and the matrix of the primitive at hand (see records.s).
        .regs   r40, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10
        .regs   r51, sh11, sh12, sh13, sh14, sh15
        .regs   r56, m00, m01, m02, m03, m10, m11, m12, m13, m20, m21, m22, m23

; Queue vectors, all n long.
        .regs   r70, hit_s, hit_t, patch_s, patch_t       ; on patches
        .regs   r74, wlower, llower                       ; least distances
        .regs   r80, wox, woy, woz, wdx, wdy, wdz         ; rays, world
        .regs   r86, lox, loy, loz, ldx, ldy, ldz, lscale ; rays, own space
        .regs   r93, tin, tout                            ; of the kernel
        .regs   r95, nearest, nearest_id                  ; so far
        .regs   r97, w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11
        .regs   r109, bits0, bits1, bits2                 ; bit vectors
        .reg    iota, r112                                 ; 0, 1, 2, ...
        .equ    QUEUE_VECTORS, 43

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

; The frame's planes, from the queue's first pixel on, n long.
        .regs   r124, out_red, out_green, out_blue, out_depth, out_nx, out_ny
        .regs   r130, out_nz, out_id

; What camera.s made, for generate_vector.s.
        .regs   r170, viewlx, viewly, viewlz, basex, basey, basez, colx, coly
        .regs   r178, colz, rowx, rowy, rowz
        .reg    width, r182

; The integers 1 and -1, for counting, and the number -1.
        .regs   r183, one_index, minus_one_index
        .reg    minus_one, r192

; Vectors for shading the m rays that hit one primitive, all m long.
        .reg    m, r134
        .reg    m_high, r135
        .regs   r136, at                                  ; their places in n
        .regs   r137, px, py, pz, hdx, hdy, hdz           ; point, direction
        .regs   r143, nx, ny, nz                          ; normal
        .regs   r146, cr, cg, cb                          ; pigment
        .regs   r149, red, green, blue                    ; light so far
        .regs   r152, lx, ly, lz                          ; towards the light
        .regs   r155, facing                              ; direction . normal
        .regs   r156, v0, v1, v2, v3, v4, v5, v6, v7
        .regs   r164, hits0, hits1, hits2, hits3        ; bit vectors
        .equ    SHADE_VECTORS, 32

        .data
queue_bases:
        .rept 6
        .descriptor 0, queue_store + 64 * QUEUE * \+
        .endr
        .rept 4
        .descriptor 0, 0                ; r76-r79 are not of this table
        .endr
        .rept 29
        .descriptor 0, queue_store + 64 * QUEUE * (6 + \+)
        .endr
        .descriptor 0, queue_bits
        .descriptor 0, queue_bits + 64 * QUEUE_BIT_WORDS
        .descriptor 0, queue_bits + 128 * QUEUE_BIT_WORDS
        .descriptor 0, queue_store + 64 * QUEUE * 35
queue_descriptors:
        .space QUEUE_VECTORS

shade_bases:
        .rept 28
        .descriptor 0, shade_store + 64 * QUEUE * \+
        .endr
        .descriptor 0, shade_bits
        .descriptor 0, shade_bits + 64 * QUEUE_BIT_WORDS
        .descriptor 0, shade_bits + 128 * QUEUE_BIT_WORDS
        .descriptor 0, shade_bits + 192 * QUEUE_BIT_WORDS
shade_descriptors:
        .space SHADE_VECTORS

        .equ    QUEUE_BIT_WORDS, (QUEUE + 63) / 64
queue_bits:     .space 3 * QUEUE_BIT_WORDS
shade_bits:     .space 4 * QUEUE_BIT_WORDS
        .align 64
queue_store:    .space 36 * QUEUE
shade_store:    .space 28 * QUEUE
        .code

; The queue's rays become n (an integer) long: all descriptors from s0 on.
        .macro  set_lengths count, high, bases, descriptors, number, first
        SHIFTI  \count, 48, \high
        EX      s0, \bases
        ELEN    s0, \number
        EX      s1, \descriptors
        ELEN    s1, \number
        ORV     [s0], \high, [s1]
        SWAP    [s1], \first, [r0]
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
