; forms_vector.s - the vector form of the shapes: the operations on a queue of
; rays.
;
; A shape NAME.s is written once, with the operations below and those of forms.s
; with the prefix ray_.  The scalar form (forms_scalar.s) intersects one ray,
; the vector form the near rays of the queue.  Both call words of the ray and of
; its segment by the same names: ox oy oz dx dy dz tin tout, and t0 .. t9.
;
; A set of rays is a bit vector.  In the scalar form a ray that does not belong
; to the set branches to `out`; only sets that are turned are words there, 0
; or 1.

        .include "forms.s"
        vector_form ray_, bits0
        .reg    t0, w0
        .reg    t1, w1
        .reg    t2, w2
        .reg    t3, w3
        .reg    t4, w4
        .reg    t5, w5
        .reg    t6, w6
        .reg    t7, w7
        .reg    t8, w8
        .reg    t9, w6
        .reg    number, s1
        .reg    least, lower
; Of the shapes that solve a quadratic.
        .reg    shift, w9
        .reg    quad_a, w10
        .reg    quad_b, w11
        .reg    quad_c, w4
        .reg    o_along, w5
        .reg    d_along, w6
        .reg    k_along, w3
        .reg    chosen, bits0

; Includes the file of the form.
        .macro  include_form shape
        .include "shapes/\shape\()_vector.s"
        .endm

; a, b, c = the products of x with three rows of numbers.
        .macro  dot_constants x0, x1, x2, a0, a1, a2, b0, b1, b2, c0, c1, c2, a, b, c, work, w1=, w2=, w3=
        dot_constant \x0, \x1, \x2, \a0, \a1, \a2, \a, \work
        dot_constant \x0, \x1, \x2, \b0, \b1, \b2, \b, \work
        dot_constant \x0, \x1, \x2, \c0, \c1, \c2, \c, \work
        .endm

; y = A x for the symmetric matrix of a quadric's record.
        .macro  times_matrix x0, x1, x2, y0, y1, y2, work, w1=, w2=, w3=
        dot_constants \x0, \x1, \x2, sh3, sh6, sh7, sh6, sh4, sh8, sh7, sh8, sh5, \y0, \y1, \y2, \work
        .endm

; c = a - k b, f = d - k e, i = g - k h.
        .macro  from_scaled_three k, a, b, c, d, e, f, g, h, i
        ray_from_scaled \a, \b, \k, \c
        ray_from_scaled \d, \e, \k, \f
        ray_from_scaled \g, \h, \k, \i
        .endm

        .macro  cross_vectors x0, x1, x2, y0, y1, y2, c0, c1, c2, work
        cross   \x0, \x1, \x2, \y0, \y1, \y2, \c0, \c1, \c2, \work
        .endm

; ---- Begin and end -----------------------------------------------------------

; Declare what the scalar form saves.
        no_code saves

        .macro  shape_record shape, words, at, first=one
        .equ    \shape\()_words, \words
        .endm

        .macro  enter_shape shape, first=one
        load_record P_SHAPE, \shape\()_words, sh0
        .endm

        .macro  enter_columns shape, words
        load_record P_SHAPE, \words, sh0
        .endm

        .macro  leave_shape first=one
        BIM     0, link_kernel
        .endm

; The rays that branched to label miss.
        no_code missed

; ---- Sets of rays ------------------------------------------------------------

; The rays with k >= a.
        .macro  set_number_not_less k, a, set, out
        CMPGEV  \k, [\a], [\set]
        .endm

; Keep those rays of the set with a < b, or a >= b.
        .macro  keep_less a, b, set, out
        CMPLTV  [\a], [\b], [bits0]
        ANDB    [bits0], [\set], [\set]
        .endm

        .macro  keep_number_less k, a, set, out
        CMPLTV  \k, [\a], [bits0]
        ANDB    [bits0], [\set], [\set]
        .endm

        .macro  keep_not_less a, b, set, out
        CMPGEV  [\a], [\b], [bits0]
        ANDB    [bits0], [\set], [\set]
        .endm

        .macro  keep_not_less_number a, k, set, out, work=bits0
        CMPGEV  [\a], \k, [\work]
        ANDB    [\work], [\set], [\set]
        .endm

        .macro  keep_number_not_less k, a, set, out, work=bits0
        keep_where CMPGEV, \k, [\a], \set, \work
        .endm

; rest = the rays of the set without k < a; from else_in on those with k < a.
; less has all rays with k < a.
        .macro  unless_number_less k, a, set, rest, less, label
        CMPLTV  \k, [\a], [\less]
        ANDNB   [\set], [\less], [\rest]
        .endm

        .macro  else_in set, rest, less, end, label
        ANDB    [\set], [\less], [\rest]
        .endm

; Removes rays that have branched in the scalar form.
        .macro  remove bits, set
        ANDNB   [\set], [\bits], [\set]
        .endm

; Turning a ray of other: it belongs to other if it did not.  turn turns those
; of set, turn_if_less those of set with a < b.  keep_less_or_turn turns those
; with a >= b and keeps the rest.
        .macro  turn set, other
        XORB    [\other], [\set], [\other]
        .endm

        .macro  turn_if_less a, b, set, other
        CMPLTV  [\a], [\b], [bits0]
        ANDB    [bits0], [\set], [bits0]
        XORB    [\other], [bits0], [\other]
        .endm

        .macro  keep_less_or_turn a, b, set, other, out
        CMPGEV  [\a], [\b], [bits0]
        ANDB    [bits0], [\set], [bits0]
        XORB    [\other], [bits0], [\other]
        keep_less \a, \b, \set, \out
        .endm

; c = the rays of one of the sets that are not in the other.
        .macro  exclusive set, other, c
        XORB    [\set], [\other], [\c]
        .endm

        .macro  clear_set set
        XORB    [\set], [\set], [\set]
        .endm

; The following operations are for the rays of a set that is a word in the
; scalar form.
        no_code in_set

        .macro  skip_empty set, out
        if_none \set, s0, \out
        .endm

; What follows, up to out, is for the rays of a set that is a word.
        .macro  if_any set, out
        skip_empty \set, \out
        .endm

; The end of what follows if_any; the scalar form goes to label.
        no_code done

        .macro  copy_set set, other
        ANDB    [\set], [\set], [\other]
        .endm

; Operations for the rays of a set.
        .macro  copy_in set, a, c
        VTOV    [\a], [\c] ? [\set]
        .endm

        .macro  number_in set, k, c
        VTOV    \k, [\c] ? [\set]
        .endm

; c = k, or a for other rays.
        .macro  either_number set, k, a, c
        MASKV   \k, [\a], [\c] ? [\set]
        .endm

; c = a and z = x for the rays of the set, else c = b and z = y.
        .macro  either_two set, a, b, c, x, y, z
        MASKV   [\a], [\b], [\c] ? [\set]
        MASKV   [\x], [\y], [\z] ? [\set]
        .endm

; c = a / b; b changes.
        .macro  quotient_in set, a, b, c
        MASKV   [\b], one, [\b] ? [\set]
        DIVSV   [\a], [\b], [\c]
        .endm

; ---- Segments ----------------------------------------------------------------

; c = a / b.  Rays with |b| < tiny are parallel: bits0.  Their b becomes 1.
        .macro  divide_unless_parallel a, b, c, out
        CMPLTV  |[\b]|, tiny, [bits0]
        MASKV   one, [\b], [\b] ? [bits0]
        DIVSV   [\a], [\b], [\c]
        .endm

; What follows, up to end, is for the parallel rays.
        .macro  parallel_rays label, end
        if_none bits0, s0, \end
        .endm

; They are inside everywhere if a >= k, else nowhere.
        .macro  inside_if_not_less_number a, k, miss
        CMPGEV  [\a], \k, [bits1]
        everywhere_or_nowhere tin, tout
        .endm

        .macro  everywhere_or_nowhere from, to
        ANDB    [bits1], [bits0], [bits1]
        VTOV    big, [\from] ? [bits0]
        VTOV    minus_big, [\to] ? [bits0]
        VTOV    minus_big, [\from] ? [bits1]
        VTOV    big, [\to] ? [bits1]
        .endm

; from, to = the part of a ray for which t d <= a.  Changes t1, t2.
        .macro  half_space_segment a, d, from, to, miss=
        CMPLTV  |[\d]|, tiny, [bits0]
        MASKV   one, [\d], [t1] ? [bits0]
        DIVSV   [\a], [t1], [t2]
        CMPLTV  [t1], r0, [bits1]
        MASKV   [t2], minus_big, [\from] ? [bits1]
        MASKV   big, [t2], [\to] ? [bits1]
        if_none bits0, s0, space_found\@
        CMPGEV  [\a], r0, [bits1]
        everywhere_or_nowhere \from, \to
space_found\@:
        .endm

; A ray with an empty segment misses; close_segment follows in the vector form.
        no_code leave_empty

; The segment is t, big if a < k, else minus_big, t.  A ray that is not parallel
; leaves.
        .macro  leave_on_half_line a, k, t, first=one
        CMPLTV  [\a], \k, [bits1]
        MASKV   [\t], minus_big, [tin] ? [bits1]
        MASKV   big, [\t], [tout] ? [bits1]
        .endm

; tin = tout = t for the rays of the set; the others miss.
        .macro  point_in set, t
        MASKV   [\t], big, [tin] ? [\set]
        MASKV   [\t], minus_big, [tout] ? [\set]
        .endm

; Cuts the segments of the rays to the part between two parallel planes.
;
; Along one axis, with origin o, direction d and planes at low and high, near
; and far are the smaller and the greater of (low - o)/d, (high - o)/d.  The
; segment tin .. tout is cut to near .. far.
;
; The machine has no infinities.  A ray with |d| < tiny is parallel, and inside
; everywhere (minus_big, big) or nowhere (big, minus_big).
;
; Changes w0-w4, bits0-bits2, s0.

        .macro  slab o, d, low, high, miss=
        CMPLTV  |[\d]|, tiny, [bits0]
        MASKV   one, [\d], [w0] ? [bits0]
        DIVSV   one, [w0], [w0]
        LINKV
        SUBNV   \low, [\o], [w1]
        MPYSV   [w1], [w0], [w1]
        LINKV
        SUBNV   \high, [\o], [w2]
        MPYSV   [w2], [w0], [w2]
        CMPLTV  [w2], [w1], [bits1]
        MASKV   [w2], [w1], [w3] ? [bits1]
        MASKV   [w1], [w2], [w4] ? [bits1]
        if_none bits0, s0, slab_crossed\@
        VTOV    minus_big, [w3] ? [bits0]
        VTOV    big, [w4] ? [bits0]
        CMPLTV  [\o], \low, [bits1]
        CMPLTV  \high, [\o], [bits2]
        ORB     [bits1], [bits2], [bits1]
        ANDB    [bits1], [bits0], [bits1]
        VTOV    big, [w3] ? [bits1]
        VTOV    minus_big, [w4] ? [bits1]
slab_crossed\@:
        ray_not_below w3, tin
        ray_not_above w4, tout
        .endm

; Changes an empty segment to a miss.
        .macro  close_segment
        CMPLTV  [tout], [tin], [bits0]
        VTOV    big, [tin] ? [bits0]
        VTOV    minus_big, [tout] ? [bits0]
        .endm

; ---- Quadratics --------------------------------------------------------------

; Solves a queue of quadratics  a t^2 + 2 b t + c.
;
;   disc = b^2 - a c              disc < 0: no root
;   q = -(b + sign(b) sqrt(disc)) (sign(0) = +)
;   first = q / a,  second = c / q
;
; Nothing cancels in q.  The root that would cancel is c / q.  The caller
; handles two rare kinds of lanes and counts them: a = 0 (bits1) has no first
; root, q = 0 (bits2) has no second one.  There the quotient is indefinite.  q =
; 0 means b = 0 and a c = 0.
;
; In:  a, b, c.  Out: disc; then q in its place, first, second; bits0 = the root
;      is real.
; Source: textbook; the project's notes on ray tracing, 4.2.

        .macro  discriminant a, b, c, disc, work
        MPYSV   [\b], [\b], [\disc]
        MPYSV   [\a], [\c], [\work]
        SUBNV   [\disc], [\work], [\disc]
        .endm

        .macro  quadratic_roots a, b, c, disc, first, second
        CMPGEV  [\disc], r0, [bits0]
        SQRTV   [\disc], [\disc] ? [bits0]
        ADDNV   |[\b]|, [\disc], [\disc]
        CMPGEV  [\b], r0, [bits1]
        VTOV    -[\disc], [\disc] ? [bits1]
        DIVSV   [\disc], [\a], [\first]
        DIVSV   [\c], [\disc], [\second]
        CMPEQV  [\a], r0, [bits1]
        CMPEQV  [\disc], r0, [bits2]
        .endm

; tin = the smaller of first and second, tout = the greater.
        .macro  sort_roots first, second
        CMPLTV  [\second], [\first], [bits1]
        MASKV   [\second], [\first], [tin] ? [bits1]
        MASKV   [\first], [\second], [tout] ? [bits1]
        .endm

; Moves the rays' origins x, relative to the shape's centre, to o, their closest
; approach to it:  along = x . D,  o = x - along D.  A distance from o is
; greater by along than that from x.
        .macro  closest_approach x0, x1, x2, o0, o1, o2, along, work, other=
        dot_vectors \x0, \x1, \x2, dx, dy, dz, \along, \work
        MPYSV   [\along], [dx], [\work]
        SUBNV   [\x0], [\work], [\o0]
        MPYSV   [\along], [dy], [\work]
        SUBNV   [\x1], [\work], [\o1]
        MPYSV   [\along], [dz], [\work]
        SUBNV   [\x2], [\work], [\o2]
        .endm

; Measures the segments from the original origin again.
        .macro  move_back along
        CMPGEV  [tout], [tin], [bits0]
        SUBNV   [tin], [\along], [tin] ? [bits0]
        SUBNV   [tout], [\along], [tout] ? [bits0]
        .endm

; disc = 0 for the rays with disc < 0 and a < 0.
        .macro  clear_if_negative disc, a, miss
        CMPLTV  [\a], r0, [bits0]
        keep_where CMPLTV, [\disc], r0, bits0, bits1
        VTOV    r0, [\disc] ? [bits0]
        .endm

; tin, tout = the roots of the side of a cone, from disc in t2.  bits0 = the
; rays that hit it.  With a = 0, k_along = -b; without a root a ray is inside
; everywhere, and a = 1, or nowhere.
        .macro  cone_roots miss
        quadratic_roots quad_a, quad_b, quad_c, t2, t0, t1
        ORB     [bits1], [bits2], [bits1]
        if_none bits1, s0, cone_rooted\@
        CMPEQV  [quad_a], r0, [bits1]
        VTOV    [t0], [t1] ? [bits2]
        VTOV    [t1], [t0] ? [bits1]
        VTOV    -[quad_b], [k_along] ? [bits1]
        ANDB    [bits1], [bits2], [bits2]       ; lanes without a root
        VTOV    minus_big, [t0] ? [bits2]
        VTOV    big, [t1] ? [bits2]
        VTOV    one, [quad_a] ? [bits2]
        CMPLTV  r0, [quad_c], [bits1]
        ANDB    [bits1], [bits2], [bits1]
        ANDNB   [bits0], [bits1], [bits0]       ; outside everywhere
cone_rooted\@:
        sort_roots t0, t1
        VTOV    big, [tin] ?! [bits0]
        VTOV    minus_big, [tout] ?! [bits0]
        .endm

; tin, tout = the two crossings with a quadric, from disc in t2.  bits0 = the
; rays that have them; with one root tin = tout.
        .macro  quadric_roots miss=
        quadratic_roots quad_a, quad_b, quad_c, t2, t0, t1
        ORB     [bits1], [bits2], [bits1]
        if_none bits1, s0, quadric_rooted\@
        CMPEQV  [quad_a], r0, [bits1]
        VTOV    [t0], [t1] ? [bits2]
        VTOV    [t1], [t0] ? [bits1]
        ANDB    [bits1], [bits2], [bits1]
        ANDNB   [bits0], [bits1], [bits0]       ; lanes without a root
quadric_rooted\@:
        sort_roots t0, t1
        .endm

        .macro  crossings_or_miss
        VTOV    big, [tin] ?! [bits0]
        VTOV    minus_big, [tout] ?! [bits0]
        move_back shift
        .endm

; The two segments of each ray inside a quadric, from disc in t2.
; Two crossings: the ray is inside between them or, if a < 0, before the first
; and after the second.  One crossing (a = 0): it is inside before it if the
; polynomial rises.  None: it is inside everywhere or nowhere, by the sign of a
; or, if a = b = 0, of c.
        .macro  quadric_segments
        quadric_roots
        SUBNV   [tin], [shift], [tin]
        SUBNV   [tout], [shift], [tout]
        VTOV    big, [tin2]
        VTOV    minus_big, [tout2]
        VTOV    big, [tin] ?! [bits0]
        VTOV    minus_big, [tout] ?! [bits0]
        CMPLTV  r0, [quad_a], [bits1]
        CNTOB   [bits1], s0
        IBXEQ   s0, r0, near, solid_stored\@   ; a > 0 for all
        CMPLTV  [quad_a], r0, [bits1]           ; a < 0
        ANDB    [bits0], [bits1], [bits2]
        VTOV    [tout], [tin2] ? [bits2]
        VTOV    big, [tout2] ? [bits2]
        VTOV    [tin], [tout] ? [bits2]
        VTOV    minus_big, [tin] ? [bits2]
        ANDNB   [bits1], [bits0], [bits2]
        VTOV    minus_big, [tin] ? [bits2]
        VTOV    big, [tout] ? [bits2]
        CMPEQV  [quad_a], r0, [bits1]
        if_none bits1, s0, solid_stored\@
        ANDB    [bits0], [bits1], [bits0]       ; a = 0: one crossing
        ANDNB   [bits1], [bits0], [bits1]       ; a = 0: no crossing
        CMPGEV  [quad_b], r0, [bits2]
        ANDNB   [bits0], [bits2], [bits2]       ; the polynomial falls
        VTOV    big, [tout] ? [bits2]
        CMPGEV  [quad_b], r0, [bits2]
        ANDB    [bits0], [bits2], [bits2]       ; the polynomial rises
        VTOV    minus_big, [tin] ? [bits2]
        CMPLTV  [quad_c], r0, [bits2]
        ANDB    [bits1], [bits2], [bits2]       ; inside everywhere
        VTOV    minus_big, [tin] ? [bits2]
        VTOV    big, [tout] ? [bits2]
solid_stored\@:
        .endm

; ---- A cylinder in its own frame ---------------------------------------------

; Rays with a < least branch to along: bits2.  divisor = a, or 1 for these.
        .macro  sides_unless_along a, least, divisor, along
        CMPLTV  [\a], \least, [bits2]
        MASKV   one, [\a], [\divisor] ? [bits2]
        .endm

; bits0 = the rays that are not along the axis and have a real root.
        .macro  real_root disc, miss
        CMPGEV  [\disc], r0, [bits0]
        ANDNB   [bits0], [bits2], [bits0]
        SQRTV   [\disc], [\disc] ? [bits0]
        .endm

; first = -b - root, last = -b + root.
        .macro  opposite_roots b, root, first, last
        SUBNV   -[\b], [\root], [\first]
        ADDNV   -[\b], [\root], [\last]
        .endm

; bits0 = these and those along the axis, without those with |d| < tiny, which
; branch to across.  divisor = d, or 1 for these.
        .macro  ends_unless_across a, least, d, divisor, along, across
        CMPLTV  [\a], \least, [bits2]
        ORB     [bits0], [bits2], [bits0]
        CMPLTV  |[\d]|, tiny, [bits2]
        ANDNB   [bits0], [bits2], [bits0]
        MASKV   one, [\d], [\divisor] ? [bits2]
        .endm

; c = a / b, with the divisor for b.
        .macro  quotient_by a, b, divisor, c
        DIVSV   [\a], [\divisor], [\c]
        .endm

; t counts for the rays of bits0 with |a| <= k, or with a <= k: tin is the
; smallest such t, tout the greatest.
        .macro  candidate_within a, k, t
        CMPGEV  \k, |[\a]|, [bits1]
        candidate \t
        .endm

        .macro  candidate_not_above a, k, t
        CMPGEV  \k, [\a], [bits1]
        candidate \t
        .endm

        .macro  candidate t
        ANDB    [bits1], [bits0], [bits1]
        CMPLTV  [\t], [tin], [bits2]
        ANDB    [bits2], [bits1], [bits2]
        VTOV    [\t], [tin] ? [bits2]
        CMPLTV  [tout], [\t], [bits2]
        ANDB    [bits2], [bits1], [bits2]
        VTOV    [\t], [tout] ? [bits2]
        .endm

; ---- A cylinder clipped by planes --------------------------------------------

        .reg    surface_in, patch_s
        .reg    surface_out, patch_t

; bits0 = the rays parallel to the axis; their length becomes 1.
        .macro  unless_parallel length, along
        CMPLTV  [\length], tiny, [bits0]
        MASKV   one, [\length], [\length] ? [bits0]
        .endm

; set = the rays with |a| <= k.
        .macro  set_within a, k, set, out
        CMPGEV  \k, |[\a]|, [\set]
        .endm

; c = -a / b
        .macro  quotient_opposite a, b, c
        DIVSV   -[\a], [\b], [\c]
        .endm

; distance = sqrt(radius^2 - distance^2)
        .macro  half_chord distance, radius, set
        MPYS    \radius, \radius, s0
        LINKV
        MPYSV   [\distance], [\distance], [\distance]
        SUBNV   s0, [\distance], [\distance]
        SQRTV   [\distance], [\distance] ? [\set]
        .endm

; The segment is t - |half| .. t + |half| for the rays of the set; others miss.
        .macro  segment_about t, half, set
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        SUBNV   [\t], |[\half]|, [tin] ? [\set]
        ADDNV   [\t], |[\half]|, [tout] ? [\set]
        .endm

; What follows, up to end, is for the rays of bits0.
        .macro  only_parallel label, end
        skip_empty bits0, \end
        .endm

; Computes the cross product of O - B and the axis again.
        .macro  restore_across
        three   ray_lower, ox, oy, oz, sh0, sh1, sh2, t4, t5, t6
        across_axis t4, t5, t6, across0, across1, across2
        .endm

        .macro  inside_if_number_not_less k, a, miss
        CMPGEV  \k, [\a], [bits1]
        everywhere_or_nowhere tin, tout
        .endm

        .macro  record_surface surface, where, bits
        .ifndef CYLINDER_UNRECORDED
        VTOV    \surface, [\where] ? [\bits]
        .endif
        .endm

; Clips the rays by a plane.  The t of a ray parallel to the plane is set so
; that it changes nothing or makes the ray a miss.
        .macro  clip p0, p1, p2, q, surface, miss
        dot_constant dx, dy, dz, \p0, \p1, \p2, w0, w2
        dot_constant ox, oy, oz, \p0, \p1, \p2, w1, w2
        ADDNV   [w1], \q, [w1]
        CMPLTV  |[w0]|, tiny, [bits0]
        MASKV   one, [w0], [w0] ? [bits0]
        DIVSV   -[w1], [w0], [w2]
        if_none bits0, s0, clip_crossed\@
        CMPLTV  r0, [w1], [bits1]
        ANDB    [bits1], [bits0], [bits1]
        VTOV    big, [w2] ? [bits0]
        VTOV    minus_big, [w2] ? [bits1]
clip_crossed\@:
        CMPLTV  [w0], r0, [bits0]
        CMPLTV  [tin], [w2], [bits1]
        CMPLTV  [w2], [tout], [bits2]
        ANDB    [bits1], [bits0], [bits1]
        ANDNB   [bits2], [bits0], [bits2]
        VTOV    [w2], [tin] ? [bits1]
        record_surface    \surface, surface_in, bits1
        VTOV    [w2], [tout] ? [bits2]
        record_surface    \surface, surface_out, bits2
        .endm

; The scalar form stores the surfaces.
        no_code give_surfaces

; Keeps the crossings with the side.  A single one is both entry and exit.
        .macro  leave_with_side miss, recorded
        CMPLTV  [tout], [tin], [bits0]
        CMPEQV  [surface_in], r0, [bits1]
        CMPEQV  [surface_out], r0, [bits2]
        VTOV    [tin], [w0]
        VTOV    [tout], [tin] ?! [bits1]
        VTOV    [w0], [tout] ?! [bits2]
        ORB     [bits1], [bits2], [bits1]
        ORNB    [bits0], [bits1], [bits0]
        VTOV    big, [tin] ? [bits0]
        VTOV    minus_big, [tout] ? [bits0]
        BIM     0, link_kernel
        .endm
