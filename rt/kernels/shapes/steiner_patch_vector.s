; steiner_patch_vector.s - intersects a queue of rays with a Steiner patch, a
; triangle of degree two with six control points and weights, by the quartic in
; one of its parameters.
;
; Relative to the patch's centre, with four coordinates x y z w:
;
;   H(s, t) = K0 + K1 s + K2 t + K3 s^2 + K4 s t + K5 t^2
;   point = H.xyz / H.w,  s >= 0, t >= 0, s + t <= 1
;
; o is the ray's closest approach to the centre, d its direction.  Two planes
; through the ray, the first one also parallel to P, cut the patch in conics of
; s, t:
;
;   P  = K5.xyz - K5.w o
;   n2 = d x P,  without its part along d    n1 = n2 x d
;   Ai = n1 . Ki.xyz - (n1 . o) Ki.w         Bi the same with n2, B5 = 0
;
;   A5 t^2 + A(s) t + A0(s) = 0,  A0(s) = A0 + A1 s + A3 s^2,  A(s) = A2 + A4 s
;   B(s) t + B0(s) = 0,           B0(s) = B0 + B1 s + B3 s^2,  B(s) = B2 + B4 s
;
; Eliminating t = -B0(s)/B(s) leaves  R(s) = A5 B0(s)^2 + B(s) G(s),
; G(s) = A0(s) B(s) - A(s) B0(s).  If all Bernstein coefficients of R on [0, 1]
; have one sign, the ray misses.  A root of R with its t in the triangle is a
; crossing at the distance d . H.xyz / H.w; the nearest one counts.  All roots
; are computed, because they are ordered by s and not by distance.
;
; If d is parallel to P, there is no such plane, and any other serves: one
; through a vector of the patch's table.  If B(s) and B0(s) are both nearly 0,
; the second conic is a pair of lines, and the ray is in the plane of a curve s
; = const.  Then t is one of the roots of the first conic, and Newton's method
; on both conics shows which one.
;
; steiner is for weights that are all one (Ki.w = 0 except K0.w = 1),
; rational_steiner for all others.  steiner_crossings and
; rational_steiner_crossings compute all crossings, for Boolean trees.
;
; In:  ox oy oz dx dy dz lower, n long; the primitive's record and table.
; Out: tin = tout = the nearest crossing; a miss is big, minus_big;
;      patch_s, patch_t where there is a crossing.
; steiner_crossings, rational_steiner_crossings:
; In:  also tin, PATCH_CROSSINGS successive vectors, and as many for patch_s and
;      patch_t.
; Out: in these the crossings ahead, unsorted, then big; their parameters.
; Source: the project's notes on ray tracing, 2.3, which derive it.

        .ifndef LANE_VECTORS
        .include "shapes/lanes_vector.s"
        .endif
        .include "shapes/steiner_constants.s"

; The patch's table.
        .share  shape
        .regs   r40, kx0, ky0, kz0, kx1, ky1, kz1, kx2, ky2, kz2, kx3, ky3, kz3
        .regs   r52, kx4, ky4, kz4, kx5, ky5, kz5
        .regs   r58, kw0, kw1, kw2, kw3, kw4, kw5
        .regs   r64, other_x, other_y, other_z
        .endshare
        .equ    PATCH_TABLE, 27

        .reg    patch_link, r132
        .share  phase
        .regs   r168, patch_low, patch_high
        .regs   r196, candidate_s, candidate_t          ; descriptors
        .reg    candidate_routine, r198
        .endshare

; Computes the coefficient c of a conic from the plane n and the constants of K;
; no = n . o.
        .macro  conic n0, n1, n2, kx, ky, kz, c
        dot_constant \n0, \n1, \n2, \kx, \ky, \kz, \c, e12
        .endm

        .macro  rational_conic n0, n1, n2, no, kx, ky, kz, kw, c
        conic   \n0, \n1, \n2, \kx, \ky, \kz, \c
        LINKV
        MPYSV   [\no], \kw, [e12]
        SUBNV   [\c], [e12], [\c]
        .endm

; Computes six coefficients of the first conic and five of the second.
        .macro  conics rational
        dot_vectors n1x, n1y, n1z, lane_ox, lane_oy, lane_oz, e0, e12
        dot_vectors n2x, n2y, n2z, lane_ox, lane_oy, lane_oz, e1, e12
        .if     \rational
        rational_conic n1x, n1y, n1z, e0, kx0, ky0, kz0, kw0, pa0
        rational_conic n1x, n1y, n1z, e0, kx1, ky1, kz1, kw1, pa1
        rational_conic n1x, n1y, n1z, e0, kx2, ky2, kz2, kw2, pa2
        rational_conic n1x, n1y, n1z, e0, kx3, ky3, kz3, kw3, pa3
        rational_conic n1x, n1y, n1z, e0, kx4, ky4, kz4, kw4, pa4
        rational_conic n1x, n1y, n1z, e0, kx5, ky5, kz5, kw5, pa5
        rational_conic n2x, n2y, n2z, e1, kx0, ky0, kz0, kw0, pb0
        rational_conic n2x, n2y, n2z, e1, kx1, ky1, kz1, kw1, pb1
        rational_conic n2x, n2y, n2z, e1, kx2, ky2, kz2, kw2, pb2
        rational_conic n2x, n2y, n2z, e1, kx3, ky3, kz3, kw3, pb3
        rational_conic n2x, n2y, n2z, e1, kx4, ky4, kz4, kw4, pb4
        .else
        conic   n1x, n1y, n1z, kx0, ky0, kz0, pa0
        SUBNV   [pa0], [e0], [pa0]
        conic   n1x, n1y, n1z, kx1, ky1, kz1, pa1
        conic   n1x, n1y, n1z, kx2, ky2, kz2, pa2
        conic   n1x, n1y, n1z, kx3, ky3, kz3, pa3
        conic   n1x, n1y, n1z, kx4, ky4, kz4, pa4
        conic   n1x, n1y, n1z, kx5, ky5, kz5, pa5
        conic   n2x, n2y, n2z, kx0, ky0, kz0, pb0
        SUBNV   [pb0], [e1], [pb0]
        conic   n2x, n2y, n2z, kx1, ky1, kz1, pb1
        conic   n2x, n2y, n2z, kx2, ky2, kz2, pb2
        conic   n2x, n2y, n2z, kx3, ky3, kz3, pb3
        conic   n2x, n2y, n2z, kx4, ky4, kz4, pb4
        .endif
        .endm

; Computes the normals of the two planes.  A ray counts as parallel to P if
; |d x P|^2 <= 2^-72 |P|^2.  For a rational patch P is in e0-e2.
        .macro  planes rational
        .if     \rational
        LINKV
        MPYSV   [lane_ox], kw5, [e0]
        SUBNV   kx5, [e0], [e0]
        LINKV
        MPYSV   [lane_oy], kw5, [e1]
        SUBNV   ky5, [e1], [e1]
        LINKV
        MPYSV   [lane_oz], kw5, [e2]
        SUBNV   kz5, [e2], [e2]
        cross   lane_dx, lane_dy, lane_dz, e0, e1, e2, n2x, n2y, n2z, e12
        dot_vectors e0, e1, e2, e0, e1, e2, e3, e12
        MPYSV   [e3], s2, [e3]
        .else
        cross_constant lane_dx, lane_dy, lane_dz, kx5, ky5, kz5, n2x, n2y, n2z, e12
        VTOV    s2, [e3]
        .endif
        dot_vectors n2x, n2y, n2z, n2x, n2y, n2z, spread, e12
        CMPGEV  [e3], [spread], [hits0]
        CNTOB   [hits0], s0
        IBXEQ   s0, r0, r0, planes_found\@
        cross_constant lane_dx, lane_dy, lane_dz, other_x, other_y, other_z, e0, e1, e2, e12
        VTOV    [e0], [n2x] ? [hits0]
        VTOV    [e1], [n2y] ? [hits0]
        VTOV    [e2], [n2z] ? [hits0]
        dot_vectors n2x, n2y, n2z, n2x, n2y, n2z, spread, e12
planes_found\@:
        MPYSV   [spread], s3, [spread]
        dot_vectors n2x, n2y, n2z, lane_dx, lane_dy, lane_dz, e0, e12
        MPYSV   [e0], [lane_dx], [e1]
        SUBNV   [n2x], [e1], [n2x]
        MPYSV   [e0], [lane_dy], [e1]
        SUBNV   [n2y], [e1], [n2y]
        MPYSV   [e0], [lane_dz], [e1]
        SUBNV   [n2z], [e1], [n2z]
        cross   n2x, n2y, n2z, lane_dx, lane_dy, lane_dz, n1x, n1y, n1z, e12
        .endm

        .macro  add_product a, b, sum
        MPYSV   [\a], [\b], [e12]
        ADDNV   [\sum], [e12], [\sum]
        .endm

        .macro  subtract_product a, b, sum
        MPYSV   [\a], [\b], [e12]
        SUBNV   [\sum], [e12], [\sum]
        .endm

; Computes k4 .. k0 = R, with G in e0-e3 and B0(s)^2 in e4-e8.
        .macro  eliminate
        MPYSV   [pa0], [pb2], [e0]
        subtract_product pa2, pb0, e0
        MPYSV   [pa0], [pb4], [e1]
        add_product pa1, pb2, e1
        subtract_product pa2, pb1, e1
        subtract_product pa4, pb0, e1
        MPYSV   [pa1], [pb4], [e2]
        add_product pa3, pb2, e2
        subtract_product pa2, pb3, e2
        subtract_product pa4, pb1, e2
        MPYSV   [pa3], [pb4], [e3]
        subtract_product pa4, pb3, e3
        MPYSV   [pb0], [pb0], [e4]
        LINKV
        MPYSV   [pb0], [pb1], [e5]
        ADDNV   [e5], [e5], [e5]
        LINKV
        MPYSV   [pb0], [pb3], [e6]
        ADDNV   [e6], [e6], [e6]
        add_product pb1, pb1, e6
        LINKV
        MPYSV   [pb1], [pb3], [e7]
        ADDNV   [e7], [e7], [e7]
        MPYSV   [pb3], [pb3], [e8]
        MPYSV   [pa5], [e4], [k0]
        add_product pb2, e0, k0
        MPYSV   [pa5], [e5], [k1]
        add_product pb2, e1, k1
        add_product pb4, e0, k1
        MPYSV   [pa5], [e6], [k2]
        add_product pb2, e2, k2
        add_product pb4, e1, k2
        MPYSV   [pa5], [e7], [k3]
        add_product pb2, e3, k3
        add_product pb4, e2, k3
        MPYSV   [pa5], [e8], [k4]
        add_product pb4, e3, k4
        .endm

; hits0 = all Bernstein coefficients of R (k0, e0-e3) exceed the rounding
; errors; hits1 = all are below the negative of these.
        .macro  bernstein_sign c
        CMPLTV  [e4], [\c], [hits2]
        ANDB    [hits0], [hits2], [hits0]
        CMPLTV  [\c], [e5], [hits2]
        ANDB    [hits1], [hits2], [hits1]
        .endm

        .macro  bernstein_signs
        EX      s2, patch_numbers
        ELEN    s2, 3
        SWAP    [s2], s3, [r0]                  ; 1/4, 1/6, noise
        ADDNV   |[k0]|, |[k1]|, [e4]
        ADDNV   |[k2]|, [e4], [e4]
        ADDNV   |[k3]|, [e4], [e4]
        LINKV
        ADDNV   |[k4]|, [e4], [e4]
        MPYSV   [e4], s5, [e4]
        MPYSV   [k1], s3, [e5]
        MPYSV   [k2], s4, [e6]
        MPYSV   [k3], s3, [e7]
        ADDNV   [k0], [e5], [e0]
        ADDNV   [e5], [e6], [e8]
        ADDNV   [e0], [e8], [e1]
        ADDNV   [e8], [e6], [e8]
        ADDNV   [e8], [e7], [e8]
        ADDNV   [e1], [e8], [e2]
        ADDNV   [k0], [k1], [e3]
        ADDNV   [e3], [k2], [e3]
        ADDNV   [e3], [k3], [e3]
        ADDNV   [e3], [k4], [e3]
        VTOV    -[e4], [e5]
        CMPLTV  [e4], [k0], [hits0]
        CMPLTV  [k0], [e5], [hits1]
        bernstein_sign e0
        bernstein_sign e1
        bernstein_sign e2
        bernstein_sign e3
        .endm

; patch_distance: of the candidates [candidate_s], [candidate_t] in the lanes of
; hits2, keeps those in the triangle and beyond the lower limit.  [e3] = their
; distances.  Branches to none if there are none.
        .macro  patch_coordinate k0, k1, k2, k3, k4, k5, sum
        LINKV
        MPYSV   [candidate_s], \k1, [\sum]
        ADDNV   [\sum], \k0, [\sum]
        patch_part candidate_t, \k2, \sum
        patch_part e4, \k3, \sum
        patch_part e5, \k4, \sum
        patch_part e6, \k5, \sum
        .endm

        .macro  patch_part power, k, sum
        LINKV
        MPYSV   [\power], \k, [e12]
        ADDNV   [e12], [\sum], [\sum]
        .endm

        .macro  patch_distance rational, none
        CMPGEV  [candidate_t], patch_low, [hits3]
        ANDB    [hits2], [hits3], [hits2]
        ADDNV   [candidate_s], [candidate_t], [e3]
        CMPGEV  patch_high, [e3], [hits3]
        ANDB    [hits2], [hits3], [hits2]
        CNTOB   [hits2], s0
        IBXEQ   s0, r0, r0, \none
        MPYSV   [candidate_s], [candidate_s], [e4]
        MPYSV   [candidate_s], [candidate_t], [e5]
        MPYSV   [candidate_t], [candidate_t], [e6]
        patch_coordinate kx0, kx1, kx2, kx3, kx4, kx5, e7
        patch_coordinate ky0, ky1, ky2, ky3, ky4, ky5, e8
        patch_coordinate kz0, kz1, kz2, kz3, kz4, kz5, e9
        dot_vectors lane_dx, lane_dy, lane_dz, e7, e8, e9, e3, e12
        .if     \rational
        patch_coordinate kw0, kw1, kw2, kw3, kw4, kw5, e10
        DIVSV   [e3], [e10], [e3]
        .endif
        CMPLTV  [lane_low], [e3], [hits3]
        ANDB    [hits2], [hits3], [hits2]
        SUBNV   [e3], [lane_along], [e3]
        .endm

; Replaces tin by the candidates that are nearer.
        .macro  patch_candidate rational
        patch_distance \rational, candidate_none\@
        VXTOV   [lane_at], [tin], [e4]
        CMPLTV  [e3], [e4], [hits3]
        ANDB    [hits2], [hits3], [hits2]
        VTOVX   [lane_at], [e3], [tin] ? [hits2]
        VTOVX   [lane_at], [candidate_s], [patch_s] ? [hits2]
        VTOVX   [lane_at], [candidate_t], [patch_t] ? [hits2]
candidate_none\@:
        BIM     0, patch_link
        .endm

; Appends every candidate to the next of its ray's vectors, while there are any.
; lane_at then is the ray's index in the vector after that.
        .macro  patch_crossing rational
        patch_distance \rational, crossing_none\@
        EX      s0, PATCH_CROSSINGS * QUEUE
        CMPLTV  [lane_at], s0, [hits3]
        ANDB    [hits2], [hits3], [hits2]
        VTOVX   [lane_at], [e3], [tin] ? [hits2]
        VTOVX   [lane_at], [candidate_s], [patch_s] ? [hits2]
        VTOVX   [lane_at], [candidate_t], [patch_t] ? [hits2]
        EX      s0, QUEUE
        ADDXV   [lane_at], s0, [lane_at] ? [hits2]
crossing_none\@:
        BIM     0, patch_link
        .endm

; One step of Newton's method on both conics: subtracts e0 and e1 from s and t.
        .macro  newton_step
        MPYSV   [pa3], [candidate_s], [e0]
        MPYSV   [pa4], [candidate_t], [e1]
        ADDNV   [pa1], [e0], [e2]
        ADDNV   [e2], [e1], [e2]
        ADDNV   [e2], [e0], [e3]                ; by s
        MPYSV   [pa5], [candidate_t], [e0]
        ADDNV   [pa2], [e0], [e4]
        ADDNV   [e4], [e0], [e5]
        add_product pa4, candidate_s, e5        ; by t
        MPYSV   [e2], [candidate_s], [e2]
        ADDNV   [pa0], [e2], [e2]
        add_product e4, candidate_t, e2         ; the first conic
        MPYSV   [pb3], [candidate_s], [e0]
        MPYSV   [pb4], [candidate_t], [e1]
        ADDNV   [pb1], [e0], [e6]
        ADDNV   [e6], [e1], [e6]
        ADDNV   [e6], [e0], [e7]                ; by s
        MPYSV   [pb4], [candidate_s], [e8]
        ADDNV   [e8], [pb2], [e8]               ; by t
        MPYSV   [e6], [candidate_s], [e6]
        ADDNV   [pb0], [e6], [e6]
        add_product pb2, candidate_t, e6        ; the second
        MPYSV   [e3], [e8], [e9]
        subtract_product e5, e7, e9             ; determinant
        MPYSV   [e2], [e8], [e0]
        subtract_product e6, e5, e0
        DIVSV   [e0], [e9], [e0]
        MPYSV   [e6], [e3], [e1]
        subtract_product e2, e7, e1
        DIVSV   [e1], [e9], [e1]
        SUBNV   [candidate_s], [e0], [candidate_s]
        SUBNV   [candidate_t], [e1], [candidate_t]
        .endm

; Keeps only the lanes of hits0.
        .macro  keep vector
        CPSV    [\vector], [\vector] ? [hits0]
        .endm

; Advances to the next root: rotates the vectors and decrements the count.
        .macro  next_root
        RTOR    root0, s2
        RTOR    root1, root0
        RTOR    root2, root1
        RTOR    root3, root2
        RTOR    s2, root3
        SUBNV   [root_count], one, [root_count]
        .endm

        .macro  clear_nearest
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        .endm

        .macro  clear_crossings
        VTOV    big, [tin]
        VTOV    big, [tout]
        VTOV    big, [tin2]
        VTOV    big, [tout2]
        .endm

        .macro  steiner_lanes rational
        load_record P_SHAPE, 6, sh0
        SUBNV   [ox], sh0, [w8]
        SUBNV   [oy], sh1, [w9]
        SUBNV   [oz], sh2, [w10]
        find_lanes w8, w9, w10, sh3, steiner_miss
        take_lanes
        set_more_lanes m
        RTOR    sh4, s2
        RTOR    sh5, s3
        load_field P_TABLE, shape_at
        ELEN    shape_at, PATCH_TABLE
        SWAP    [shape_at], kx0, [r0]
        planes  \rational
        conics  \rational
        .endm

        .kernel steiner
rational_steiner_crossings:
        EX      candidate_routine, rational_crossing
        clear_crossings
        BIM     steiner_rational
rational_steiner:
        EX      candidate_routine, rational_candidate
        clear_nearest
steiner_rational:
        steiner_lanes 1
        BIM     steiner_eliminate
steiner_crossings:
        EX      candidate_routine, polynomial_crossing
        clear_crossings
        BIM     steiner_polynomial
steiner:
        EX      candidate_routine, polynomial_candidate
        clear_nearest
steiner_polynomial:
        steiner_lanes 0
steiner_eliminate:
        eliminate
        bernstein_signs
        ORB     [hits0], [hits1], [hits0]
        CNTOB   [hits0], s0
        IBXEQ   s0, r0, m, steiner_miss
        EX      s2, patch_limits
        ELEN    s2, 3
        SWAP    [s2], s7, [r0]                  ; low, high, resolution
        RTOR    s7, patch_low
        RTOR    s8, patch_high
        VTOV    patch_low, [e0]
        VTOV    patch_high, [e1]
        VTOV    patch_low, [e1] ? [hits0]       ; no interval: no root
        RTOR    link_inner, lane_link
        EX      s8, solve_quartic_all
        call_quartic s8, k4, k3, k2, k1, k0, e0, e1, s9
        RTOR    lane_link, link_inner

; One pass per root, with the lanes that have another one.
steiner_root:
        CMPLTV  r0, [root_count], [hits0]
        CNTOB   [hits0], s2
        IBXEQ   s2, r0, r0, steiner_done
        IBXEQ   s2, r0, m, steiner_taken
        RTOR    s2, m
        keep    lane_at
        keep    lane_dx
        keep    lane_dy
        keep    lane_dz
        keep    lane_along
        keep    lane_low
        keep    pa0
        keep    pa1
        keep    pa2
        keep    pa3
        keep    pa4
        keep    pa5
        keep    pb0
        keep    pb1
        keep    pb2
        keep    pb3
        keep    pb4
        keep    spread
        keep    root0
        keep    root1
        keep    root2
        keep    root3
        keep    root_count
        set_lanes m
        set_more_lanes m
steiner_taken:
        MPYSV   [pb3], [root0], [e0]
        ADDNV   [e0], [pb1], [e0]
        MPYSV   [e0], [root0], [e0]
        ADDNV   [e0], [pb0], [e0]               ; B0(s)
        MPYSV   [pb4], [root0], [e1]
        ADDNV   [e1], [pb2], [e1]               ; B(s)
        DIVSV   -[e0], [e1], [e2]
        MPYSV   [e1], [e1], [e3]
        CMPGEV  [spread], [e3], [hits0]
        MPYSV   [e0], [e0], [e3]
        CMPGEV  [spread], [e3], [hits1]
        ANDB    [hits0], [hits1], [hits1]       ; both nearly 0
        NANDB   [hits1], [hits1], [hits2]
        RTOR    root0, candidate_s
        RTOR    e2, candidate_t
        BSAVE   patch_link, [candidate_routine]
        CNTOB   [hits1], s2
        IBXNE   s2, r0, r0, steiner_lines
steiner_next:
        next_root
        BIM     steiner_root
steiner_done:
        IBXNE   segments_wanted, r0, one_index, steiner_miss
        CMPLTV  [tin], big, [bits0]
        VTOV    [tin], [tout] ? [bits0]
        BIM     0, link_kernel
steiner_miss:
        BIM     0, link_kernel

; In the lanes of hits1 the second conic is a pair of lines: t is a root of the
; first.
steiner_lines:
        MPYSV   [pa4], [root0], [e1]
        LINKV
        ADDNV   [e1], [pa2], [e1]
        MPYSV   [e1], half, [e1]
        MPYSV   [pa3], [root0], [e0]
        ADDNV   [e0], [pa1], [e0]
        MPYSV   [e0], [root0], [e0]
        ADDNV   [e0], [pa0], [e0]
        discriminant pa5, e1, e0, e2, e3
        quadratic_roots pa5, e1, e0, e2, f0, f1
        ANDB    [hits1], [bits0], [hits1]
        RTOR    f0, candidate_t
        EX      s2, steiner_newton
        BSAVE   patch_link, [s2]
        RTOR    f1, candidate_t
        EX      s2, steiner_newton
        BSAVE   patch_link, [s2]
        BIM     steiner_next
steiner_newton:
        RTOR    f2, candidate_s
        VTOV    [root0], [f2]
        .rept   3
        newton_step
        .endr
        EX      s2, patch_numbers + 64 * 3
        LOD     [s2], s2
        ADDNV   |[e0]|, |[e1]|, [e0]
        CMPLTV  [e0], s2, [hits2]
        ANDB    [hits1], [hits2], [hits2]
        CMPGEV  [candidate_s], patch_low, [hits3]
        ANDB    [hits2], [hits3], [hits2]
        BIM     0, candidate_routine

polynomial_candidate:
        patch_candidate 0
rational_candidate:
        patch_candidate 1
polynomial_crossing:
        patch_crossing 0
rational_crossing:
        patch_crossing 1
        .endkernel

        .ifdef  HISTORICAL
        .include "shapes/steiner_implicit_vector.s"
        .endif
