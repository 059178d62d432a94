; steiner_patch.s - intersects rays with a Steiner patch, a triangle of degree
; two with six control points and weights, by the quartic in one of its
; parameters.
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
; The scalar form:
;
;       CALL STEINER (RAY, PRIMITIVE, SEGMENT)
;       CALL RATIONAL_STEINER (RAY, PRIMITIVE, SEGMENT)
;       CALL STEINER_CROSSINGS (RAY, PRIMITIVE, CROSSINGS)
;       CALL RATIONAL_STEINER_CROSSINGS (RAY, PRIMITIVE, CROSSINGS)
;
; The arguments are those of sphere_scalar.s.  The parameters of the hit are
; stored in P_PATCH_POINT.  CROSSINGS receives all crossings, unsorted, then big
; (PATCH_CROSSINGS words); their parameters are stored in P_PATCH_POINTS.
;
; The vector form:
;
; In:  ox oy oz dx dy dz lower, n long; the primitive's record and table.
; Out: tin = tout = the nearest crossing; a miss is big, minus_big;
;      patch_s, patch_t where there is a crossing.
; steiner_crossings, rational_steiner_crossings:
; In:  also tin, PATCH_CROSSINGS successive vectors, and as many for patch_s and
;      patch_t.
; Out: in these the crossings ahead, unsorted, then big; their parameters.
; Record: centre 3, square of its bound, thresholds of parallel and of zero,
;         resolution of distances.  Table: K0 .. K5, their weights, another
;         plane.
; Source: the project's notes on ray tracing, 2.3, which derive it.

        include_form lanes
        .include "shapes/steiner_constants.s"
        .equ    PATCH_TABLE, 27
        include_form steiner_patch

; Removes the part of n along the direction.
        .macro  make_perpendicular n0, n1, n2
        dot_vectors \n0, \n1, \n2, near_dx, near_dy, near_dz, e3, temp0
        three_by ray_times, e3, near_dx, near_dy, near_dz, temp0, temp1, temp2
        three   ray_minus, \n0, \n1, \n2, temp0, temp1, temp2, \n0, \n1, \n2
        .endm

; Computes the normals of the two planes.  A ray counts as parallel to P if
; |d x P|^2 <= 2^-72 |P|^2.  For a rational patch P is in e0-e2.
        .macro  planes rational
        .if     \rational
        from_scaled_three kw5, kx5, near_ox, e0, ky5, near_oy, e1, kz5, near_oz, e2
        cross_vectors near_dx, near_dy, near_dz, e0, e1, e2, n2x, n2y, n2z, temp0
        dot_vectors e0, e1, e2, e0, e1, e2, e3, temp0
        ray_scale e3, parallel_limit, e3
        .else
        cross_constant near_dx, near_dy, near_dz, kx5, ky5, kz5, n2x, n2y, n2z, temp0
        ray_set parallel_limit, e3
        .endif
        dot_vectors n2x, n2y, n2z, n2x, n2y, n2z, spread, temp0
        other_plane
        ray_scale spread, spread_limit, spread
        make_perpendicular n2x, n2y, n2z
        cross_vectors n2x, n2y, n2z, near_dx, near_dy, near_dz, n1x, n1y, n1z, temp0
        .endm

; Computes three coefficients of a conic from the plane n and the constants K.
        .macro  conic n, i, j, k, c0, c1, c2
        dot_constants \n\()x, \n\()y, \n\()z, kx\i, ky\i, kz\i, kx\j, ky\j, kz\j, kx\k, ky\k, kz\k, \c0, \c1, \c2, temp0, temp1, temp2, temp3
        .endm

; Computes six coefficients of the first conic and five of the second.
        .macro  conics rational
        dot_vectors n1x, n1y, n1z, near_ox, near_oy, near_oz, e0, temp0
        dot_vectors n2x, n2y, n2z, near_ox, near_oy, near_oz, e1, temp0
        conic   n1, 0, 1, 2, pa0, pa1, pa2
        conic   n1, 3, 4, 5, pa3, pa4, pa5
        conic   n2, 0, 1, 2, pb0, pb1, pb2
        dot_constant n2x, n2y, n2z, kx3, ky3, kz3, pb3, temp0
        dot_constant n2x, n2y, n2z, kx4, ky4, kz4, pb4, temp0
        .if     \rational
        lower_conic pa, e0, 6
        lower_conic pb, e1, 5
        .else
        ray_minus pa0, e0, pa0
        ray_minus pb0, e1, pb0
        .endif
        .endm

; Computes k4 .. k0 = R, with G in g0-g3 and B0(s)^2 in e0-e4.
        .macro  eliminate
        ray_times pa0, pb2, g0
        ray_times pa2, pb0, temp0
        ray_times pa0, pb4, g1
        ray_times pa1, pb2, temp1
        ray_times pa1, pb4, g2
        ray_times pa3, pb2, temp2
        ray_times pa3, pb4, g3
        ray_times pa4, pb3, temp3
        ray_minus g0, temp0, g0
        ray_times pa2, pb1, temp0
        ray_plus g1, temp1, g1
        ray_times pa4, pb0, temp1
        ray_plus g2, temp2, g2
        ray_times pa2, pb3, temp2
        ray_minus g3, temp3, g3
        ray_times pa4, pb1, temp3
        ray_minus g1, temp0, g1
        ray_times pb0, pb0, e0
        to_double pb0, pb1, e1
        ray_minus g2, temp2, g2
        to_double pb0, pb3, e2
        ray_minus g1, temp1, g1
        ray_times pb1, pb1, temp0
        to_double pb1, pb3, e3
        ray_minus g2, temp3, g2
        doubled e1
        ray_times pb3, pb3, e4
        doubled e2
        ray_times pa5, e0, k0
        ray_times pb2, g0, temp1
        doubled e3
        ray_times pa5, e1, k1
        ray_times pb2, g1, temp2
        ray_plus e2, temp0, e2
        ray_times pb4, g0, temp3
        ray_times pa5, e4, k4
        ray_plus k0, temp1, k0
        ray_times pb4, g3, temp4
        ray_plus k1, temp2, k1
        ray_times pa5, e2, k2
        ray_times pb2, g2, temp5
        ray_times pa5, e3, k3
        ray_times pb2, g3, temp6
        ray_plus k4, temp4, k4
        ray_plus k1, temp3, k1
        ray_times pb4, g1, temp0
        ray_plus k2, temp5, k2
        ray_times pb4, g2, temp1
        ray_plus k3, temp6, k3
        ray_plus k2, temp0, k2
        ray_plus k3, temp1, k3
        .endm

; e3 = the distance of the point candidate_s, candidate_t along the ray.
; hits2 = the rays for which the point is on the patch and ahead.  Branches to
; none if there are none.
        .macro  patch_distance rational, none
        keep_in_triangle \none
        patch_coordinate kx0, kx1, kx2, kx3, kx4, kx5, temp4
        patch_coordinate ky0, ky1, ky2, ky3, ky4, ky5, temp5
        patch_coordinate kz0, kz1, kz2, kz3, kz4, kz5, e0
        dot_vectors near_dx, near_dy, near_dz, temp4, temp5, e0, e3, temp0
        .if     \rational
        patch_coordinate kw0, kw1, kw2, kw3, kw4, kw5, temp4
        ray_quotient e3, temp4, e3
        .endif
        keep_ahead \none
        ray_minus e3, along, e3
        .endm

; One step of Newton's method on both conics: subtracts e0 and e1 from s and t.
        .macro  newton_step
        ray_times pa3, candidate_s, e0
        ray_times pa4, candidate_t, e1
        ray_times pa5, candidate_t, temp0
        ray_times pa4, candidate_s, temp1
        ray_times pb3, candidate_s, temp2
        ray_times pb4, candidate_t, temp3
        ray_plus pa1, e0, e2
        ray_plus pa2, temp0, e4
        ray_times pb4, candidate_s, temp5
        ray_plus pb1, temp2, e6
        ray_plus e2, e1, e2
        ray_plus e4, temp0, e5
        ray_plus e6, temp3, e6
        ray_plus e2, e0, e3                     ; by s
        ray_plus e5, temp1, e5                  ; by t
        ray_plus e6, temp2, temp4               ; by s
        ray_plus temp5, pb2, temp5              ; by t
        ray_times e2, candidate_s, e2
        ray_times e4, candidate_t, temp0
        ray_times e6, candidate_s, e6
        ray_times pb2, candidate_t, temp1
        ray_plus pa0, e2, e2
        ray_plus pb0, e6, e6
        ray_times e3, temp5, temp3
        ray_times e5, temp4, temp2
        ray_plus e2, temp0, e2                  ; the first conic
        ray_plus e6, temp1, e6                  ; the second
        ray_minus temp3, temp2, temp3           ; determinant
        ray_times e2, temp5, e0
        ray_times e6, e5, temp0
        ray_times e6, e3, e1
        ray_times e2, temp4, temp1
        ray_minus e0, temp0, e0
        ray_minus e1, temp1, e1
        ray_quotient e0, temp3, e0
        ray_quotient e1, temp3, e1
        ray_minus candidate_s, e0, candidate_s
        ray_minus candidate_t, e1, candidate_t
        .endm

        .macro  find_conics rational
        three   ray_lower, ox, oy, oz, sh0, sh1, sh2, t5, t6, t7
        find_lanes t5, t6, t7, sh3, steiner_miss
        take_lanes
        load_patch
        planes  \rational
        conics  \rational
        .endm

        .kernel steiner
rational_steiner_crossings:
        enter_patch rational_crossing, PATCH_CROSSINGS
        BIM     steiner_rational
rational_steiner:
        enter_patch rational_candidate, 0
steiner_rational:
        find_conics 1
        BIM     steiner_eliminate
steiner_crossings:
        enter_patch polynomial_crossing, PATCH_CROSSINGS
        BIM     steiner_polynomial
steiner:
        enter_patch polynomial_candidate, 0
steiner_polynomial:
        find_conics 0
steiner_eliminate:
        eliminate
        bernstein_signs steiner_miss
        solve_patch

; One pass per root, for the rays that have another one.
steiner_root:
        begin_root steiner_done
        ray_times pb3, root_s, e0
        ray_times pb4, root_s, e1
        ray_plus e0, pb1, e0
        ray_plus e1, pb2, e1                    ; B(s)
        ray_times e0, root_s, e0
        ray_plus e0, pb0, e0                    ; B0(s)
        ray_times e1, e1, temp0
        ray_times e0, e0, temp1
        test_root steiner_lines
steiner_next:
        next_root
        BIM     steiner_root
        leave_patch steiner_done, steiner_miss

; The second conic is a pair of lines: t is a root of the first conic.
steiner_lines:
        ray_times pa4, root_s, e1
        ray_times pa3, root_s, e0
        ray_plus e0, pa1, e0
        ray_sum_scale e1, pa2, patch_half, e1
        ray_times e0, root_s, e0
        ray_plus e0, pa0, e0
        discriminant pa5, e1, e0, temp0, temp1
        first_candidate
        call_routine steiner_newton, patch_link
        second_candidate
        call_routine steiner_newton, patch_link
        BIM     steiner_next
steiner_newton:
        .rept   3
        newton_step
        .endr
        leave_newton

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
        .include "shapes/steiner_implicit.s"
        .endif
