; lanes_vector.s - selects the rays that come near a shape whose crossings the
; root solver computes, and turns their roots into tin and tout.
;
; A shape has a bounding sphere about its centre.  o is the ray's closest
; approach to the centre (forms_vector.s), and s the distance along the ray
; from there.  The ray is in the sphere for
;
;   |s| <= high = sqrt(bound^2 - o . o)
;
; Crossings count for  low < s <= high,  low = max(lower + along, -high).  A ray
; with low >= high misses.  The m other rays of the n are compressed: the lanes.
; Their descriptors are in registers of the shading, which loads them again;
; their vectors have memory of their own.
;
; Source: the project's notes on ray tracing, 0 and 1.1.

        .ifndef LANE_VECTORS
        .include "roots/quartic_vector.s"

        .reg    lane_link, r123
        .share  hits
        .regs   r136, lane_at                           ; indices in the queue
        .regs   r137, lane_ox, lane_oy, lane_oz, lane_dx, lane_dy, lane_dz
        .regs   r143, lane_along, lane_low, lane_high
        .regs   r146, k4, k3, k2, k1, k0                ; coefficients
        .regs   r151, e0, e1, e2, e3, e4, e5, e6, e7, e8, e9, e10, e11, e12
        .endshare

; The names of the scalar form.
        .regs   lane_ox, near_ox, near_oy, near_oz, near_dx, near_dy, near_dz
        .reg    along, lane_along

; More vectors of lanes, in registers that the shading loads again: r233-r253.
        .share  scratch
        .regs   r233, pa0, pa1, pa2, pa3, pa4, pa5, pb0, pb1, pb2, pb3, pb4
        .regs   r244, n1x, n1y, n1z, n2x, n2y, n2z, spread, f0, f1, f2
        .endshare
        .equ    LANE_VECTORS, 21

        .data
lane_bases:
        vector_bases LANE_VECTORS, lane_store, 0, lane_bits
lane_descriptors:
        .space  LANE_VECTORS
lane_shade_bases:
        vector_bases SHADE_VECTORS - 4, lane_shade_store, 4, lane_bits
lane_shade_descriptors:
        .space  SHADE_VECTORS
lane_bits:      .space 4 * QUEUE_BIT_WORDS
        .align  64
lane_store:     .space LANE_VECTORS * QUEUE
lane_shade_store: .space (SHADE_VECTORS - 4) * QUEUE
        .code

        .macro  set_more_lanes count
        set_lengths \count, m_high, lane_bases, lane_descriptors, LANE_VECTORS, pa0
        .endm

; Sets the lengths of the lanes' vectors, whose registers begin at first, to
; count.
        .macro  set_lanes count, first=lane_at
        set_lengths \count, m_high, lane_shade_bases, lane_shade_descriptors, SHADE_VECTORS, \first
        .endm

; The first steps of find_lanes and find_all_lanes.
        .macro  find_bound x0, x1, x2, bound2
        closest_approach \x0, \x1, \x2, w0, w1, w2, w3, w4
        dot_vectors w0, w1, w2, w0, w1, w2, w7, w4
        SUBNV   \bound2, [w7], [w6]
        CMPLTV  r0, [w6], [bits0]
        SQRTV   [w6], [w6] ? [bits0]
        .endm

; Selects the rays that come near.  x0, x1, x2 are the origins relative to the
; centre; the scalar bound2 = bound^2.  bits0 = these rays, m = their number;
; w0-w2 = o, w3 = along, w5, w6 = low, high, w7 = o . o.  Branches to miss if
; there are none.
        .macro  find_lanes x0, x1, x2, bound2, miss
        find_bound \x0, \x1, \x2, \bound2
        ADDNV   [lower], [w3], [w5]
        CMPGEV  -[w5], [w6], [bits1]
        VTOV    -[w6], [w5] ? [bits1]
        keep_where CMPLTV, [w5], [w6], bits0, bits1
        if_none bits0, m, \miss
        .endm

        .macro  take_lanes
        set_lanes m
        CPSV    [iota], [lane_at] ? [bits0]
        CPSV    [w0], [lane_ox] ? [bits0]
        CPSV    [w1], [lane_oy] ? [bits0]
        CPSV    [w2], [lane_oz] ? [bits0]
        CPSV    [dx], [lane_dx] ? [bits0]
        CPSV    [dy], [lane_dy] ? [bits0]
        CPSV    [dz], [lane_dz] ? [bits0]
        CPSV    [w3], [lane_along] ? [bits0]
        CPSV    [w5], [lane_low] ? [bits0]
        CPSV    [w6], [lane_high] ? [bits0]
        .endm

; Calls a routine of the solver with the lanes' quartics k4 .. k0.
        .macro  solve_quartics routine, low, high, resolution
        RTOR    link_inner, lane_link
        EX      target, \routine
        call_quartic target, k4, k3, k2, k1, k0, \low, \high, \resolution
        RTOR    lane_link, link_inner
        .endm

; Computes the first root of each lane's quartic k4 .. k0, with the scalar
; resolution, as tin = tout of its ray.  hits0 = the lanes that have one.
        .macro  solve_lanes resolution, routine=solve_quartic
        solve_quartics \routine, lane_low, lane_high, \resolution
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        CMPLTV  [root0], big, [hits0]
        SUBNV   [root0], [lane_along], [e0]
        VTOV    big, [e0] ?! [hits0]
        VTOVX   [lane_at], [e0], [tin]
        VTOV    minus_big, [e0] ?! [hits0]
        VTOVX   [lane_at], [e0], [tout]
        .endm

; Returns a miss for all rays.
        .macro  miss_near
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        BIM     0, link_kernel
        .endm

        .include "solids/segments_vector.s"

; ---- Tori --------------------------------------------------------------------

        .macro  enter_lanes words
        load_record P_SHAPE, \words, sh0
        .endm

        .macro  leave_at_root resolution, miss
        solve_lanes \resolution
        BIM     0, link_kernel
        .endm

; If no ray comes near the shape, all branch to passed.
        .macro  leave_with_segments resolution, passed
        solve_segments \resolution
        BIM     0, link_kernel
\passed:
        no_segments
        BIM     0, link_kernel
        .endm
        .endif
