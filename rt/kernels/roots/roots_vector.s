; roots_vector.s - computes the roots of a list of polynomials, queue by queue.
;
; For each queue of QUEUE polynomials (the last may be shorter): scale them,
; compute the roots below zero, the root at zero and those above zero, in this
; order, undo the scaling, store.  No interval contains zero, so that even the
; smallest roots are relatively accurate.  If only one root is wanted, a
; polynomial that has one is skipped in the following steps.
;
; roots_records.s describes the data that the host writes and reads.

        .include "roots/roots_records.s"

        .regs   r1, link, link_kernel, link_inner
        .regs   r6, s0, s1, s2, s3, s4, s5, s6, s7, s8, s9    ; scratch
        .include "roots/quartic_vector.s"

        .regs   r16, one, two, three, four, forty_six, most_above
        .regs   r22, most_exponent, least_exponent, unit, index_one
        .regs   r26, first, polynomials, batch, number, wanted, plane, stride
        .regs   r33, routine

; The planes, from the queue's first polynomial on, with the length of the
; queue.
        .regs   r34, c4, c3, c2, c1, c0, bound
        .regs   r40, counts, roots

; Vectors of the queue, then bit vectors, in the order of roots_descriptors and
; roots_bits_at.
        .regs   r42, d4, d3, d2, d1, d0, x_low, size, far, near
        .regs   r51, low, high, found, ray_index, t0, t1, t2
        .regs   r58, e0, e1, e2, e3, e4, top, degree, k, largest
        .equ    ROOTS_VECTORS, 25
        .regs   r80, at_zero, refused, bits0
        .regs   r83, present0, present1, present2, present3, present4
        .equ    ROOTS_BITS, 8
        .equ    ROOTS_BIT_WORDS, (QUEUE + 63) / 64

        .data
roots_vector_bases:
        .rept   ROOTS_VECTORS
        .descriptor 0, roots_store + 64 * QUEUE * \+
        .endr
roots_bits_bases:
        .rept   ROOTS_BITS
        .descriptor 0, roots_bits + 64 * ROOTS_BIT_WORDS * \+
        .endr
roots_descriptors:
        .space  ROOTS_VECTORS
roots_bits_at:
        .space  ROOTS_BITS
roots_bits:     .space ROOTS_BIT_WORDS * ROOTS_BITS
        .align  64
roots_store:    .space QUEUE * ROOTS_VECTORS
        .code

        .macro  describe_plane register
        ADDLEN  plane, batch, \register
        ADDX    plane, stride, plane
        .endm

        .macro  load_descriptors at, number, register
        EX      s0, \at
        ELEN    s0, \number
        SWAP    [s0], \register, [r0]
        .endm

; Appends the roots, times their scale, in the lanes of bits0.
        .macro  append root
        MPYSV   [\root], [size], [t0]
        CPSV    [t0], [t1] ? [bits0]
        CPSV    [ray_index], [t2] ? [bits0]
        VTOVX   [t2], [t1], [roots]
        ADDXV   [ray_index], polynomials, [ray_index] ? [bits0]
        ADDNV   [found], one, [found] ? [bits0]
        .endm

        .macro  append_counted root, least, done
        CMPGEV  [root_count], \least, [bits0]
        CNTOB   [bits0], number
        IBXEQ   number, r0, r0, \done
        append  \root
        .endm

; Appends the roots of the solver.  Branches to done when no lane has more.
        .macro  append_found done
        append_counted root0, one, \done
        IBXEQ   wanted, r0, index_one, \done
        append_counted root1, two, \done
        append_counted root2, three, \done
        append_counted root3, four, \done
        .endm

; Gives finished polynomials an empty interval: sets vector to value.
        .macro  leave_out vector, value
        IBXNE   wanted, r0, index_one, leave_out\@
        CMPGEV  [found], one, [bits0]
        VTOV    \value, \vector ? [bits0]
leave_out\@:
        .endm

        .entry  roots_begin
        .kernel quartic
roots_begin:
        load_descriptors scaling_constants, SCALING_CONSTANTS, one
        EX      s0, roots_polynomials
        LOD     [s0], polynomials
        EX      s0, roots_wanted
        LOD     [s0], wanted
        EX      routine, solve_quartic_all
        IBXNE   wanted, r0, index_one, roots_all
        EX      routine, solve_quartic
roots_all:
        ES      first, 0
        SHIFTI  polynomials, 6, stride
        IBXLE   polynomials, r0, r0, roots_end
roots_queue:
        SUBX    polynomials, first, batch
        EX      s0, QUEUE
        IBXLE   batch, r0, s0, roots_last
        RTOR    s0, batch
roots_last:
        SHIFTI  first, 6, s1
        EX      s0, roots_inputs
        LOD     [s0], plane
        ADDX    plane, s1, plane
        describe_plane c4
        describe_plane c3
        describe_plane c2
        describe_plane c1
        describe_plane c0
        describe_plane bound
        EX      s0, roots_results
        LOD     [s0], plane
        ADDX    plane, s1, plane
        describe_plane counts
        describe_plane roots
        SHIFTI  batch, 48, s2
        EX      s0, roots_vector_bases
        ELEN    s0, ROOTS_VECTORS + ROOTS_BITS
        EX      s1, roots_descriptors
        ELEN    s1, ROOTS_VECTORS + ROOTS_BITS
        ORV     [s0], s2, [s1]
        load_descriptors roots_descriptors, ROOTS_VECTORS, d4
        load_descriptors roots_bits_at, ROOTS_BITS, at_zero
        EX      s0, scale
        BSAVE   link, [s0]
        INTVLV  r0, index_one, [ray_index]
        VTOV    r0, [found]

        CMPLTV  [bound], r0, [bits0]    ; below zero
        CNTOB   [bits0], number
        IBXEQ   number, r0, r0, roots_above
        VTOV    -[far], [low]
        CMPLTV  [low], [x_low], [bits0]
        VTOV    [x_low], [low] ? [bits0]
        VTOV    -[near], [high]
        call_quartic routine, d4, d3, d2, d1, d0, low, high, r0
        append_found roots_at_zero
roots_at_zero:
        leave_out [x_low], [far]
        CMPLTV  [x_low], r0, [bits0]
        ANDB    [at_zero], [bits0], [bits0]
        VTOV    r0, [low]
        append  low
        leave_out [x_low], [far]

roots_above:
        VTOV    [near], [low]
        CMPLTV  [low], [x_low], [bits0]
        VTOV    [x_low], [low] ? [bits0]
        call_quartic routine, d4, d3, d2, d1, d0, low, far, r0
        append_found roots_found
roots_found:
        SUBN    r0, one, s0
        VTOV    s0, [found] ? [refused]
        VTOV    [found], [counts]
        ADDX    first, batch, first
        IBXLT   first, r0, polynomials, roots_queue
roots_end:
        EXIT
        .endkernel

        .include "roots/scaling_vector.s"
