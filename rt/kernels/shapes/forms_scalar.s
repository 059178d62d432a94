; forms_scalar.s - the scalar form of the shapes: the operations on one ray.
; forms_vector.s describes them.

        .include "forms.s"
        scalar_form ray_, third, fourth
        .reg    number, t9
        .reg    chosen, t0

        .macro  include_form shape
        .include "shapes/\shape\()_scalar.s"
        .endm

        .macro  dot_constant x0, x1, x2, u0, u1, u2, sum, work
        dot     \x0, \x1, \x2, \u0, \u1, \u2, \sum, \work
        .endm

        .macro  dot_constants x0, x1, x2, a0, a1, a2, b0, b1, b2, c0, c1, c2, a, b, c, w0, w1, w2, w3
        dot_rows \x0, \x1, \x2, \a0, \a1, \a2, \b0, \b1, \b2, \c0, \c1, \c2, \a, \b, \c, \w0, \w1, \w2, \w3
        .endm

        .macro  dot_vectors x0, x1, x2, y0, y1, y2, sum, work
        dot     \x0, \x1, \x2, \y0, \y1, \y2, \sum, \work
        .endm

        .macro  times_matrix x0, x1, x2, y0, y1, y2, w0, w1, w2, w3
        matrix_rows \x0, \x1, \x2, \y0, \y1, \y2, \w0, \w1, \w2, \w3
        .endm

        .macro  from_scaled_three k, a, b, c, d, e, f, g, h, i
        three_by MPYS, \k, \b, \e, \h, \c, \f, \i
        three   SUBN, \a, \d, \g, \c, \f, \i, \c, \f, \i
        .endm

        .macro  cross_vectors x0, x1, x2, y0, y1, y2, c0, c1, c2, work
        cross_product \x0, \x1, \x2, \y0, \y1, \y2, \c0, \c1, \c2
        .endm

        .macro  cross_constant x0, x1, x2, k0, k1, k2, c0, c1, c2, work
        cross_product \x0, \x1, \x2, \k0, \k1, \k2, \c0, \c1, \c2
        .endm

; ---- Begin and end -----------------------------------------------------------

; A shape saves `registers` registers; its words begin at `words`.
        .macro  saves shape, registers, words
        shape_from \words
        .equ    \shape\()_registers, \registers
        .data
\shape\()_save: .space \registers
        .code
        .endm

; A shape reads `words` words of its record into registers from `at` on, and
; saves the registers from `first` up to these.
        .macro  shape_record shape, words, at, first=one
        .equ    \shape\()_words, \words
        saves   \shape, \at + \words - 32 - (image_\first - kernel_image) / 64, r\at
        .endm

        .macro  enter_shape shape, first=one
        enter_kernel \shape\()_save, \shape\()_registers, \shape\()_words, \first
        .endm

        .macro  enter_columns shape, words
        enter_solver \words, \shape\()_save, \shape\()_registers
        RTOR    lower, least
        .endm

        .macro  leave_shape first=one
        leave_kernel \first
        .endm

        .macro  missed label, first=one
\label:
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel \first
        .endm

; ---- Sets of rays ------------------------------------------------------------

; One ray needs no code for these operations.
        no_code remove
        no_code skip_empty
        no_code copy_set
        no_code close_segment
        no_code restore_across

; A ray for which `unless` compares true branches to out.
        .macro  condition name, unless
        .macro  \name a, b, set, out, work=
        \unless \a, \b, \out
        .endm
        .endm
        condition set_number_not_less, CFPLT
        condition keep_less, CFPGE
        condition keep_number_less, CFPGE
        condition keep_not_less, CFPLT
        condition keep_not_less_number, CFPLT
        condition keep_number_not_less, CFPLT

        .macro  unless_number_less k, a, set, rest, less, label
        CFPLT   \k, \a, \label
        .endm

        .macro  else_in set, rest, less, end, label
        BIM     \end
\label:
        .endm

        .macro  turn set, other
        XOR     \other, index_one, \other
        .endm

        .macro  turn_if_less a, b, set, other
        CFPGE   \a, \b, not_turned\@
        XOR     \other, index_one, \other
not_turned\@:
        .endm

        .macro  keep_less_or_turn a, b, set, other, out
        CFPLT   \a, \b, kept\@
        XOR     \other, index_one, \other
        BIM     \out
kept\@:
        .endm

        .macro  exclusive set, other, c
        XOR     \set, \other, \c
        .endm

        .macro  clear_set set
        ES      \set, 0
        .endm

        .macro  in_set set, out
        IBXEQ   \set, r0, r0, \out
        .endm

        .macro  if_any set, out
        IBXEQ   \set, r0, r0, \out
        .endm

        .macro  done label
        BIM     \label
        .endm

        .macro  copy_in set, a, c
        RTOR    \a, \c
        .endm

        .macro  number_in set, k, c
        RTOR    \k, \c
        .endm

        .macro  either_number set, k, a, c
        RTOR    \k, \c
        .endm

        .macro  either_two set, a, b, c, x, y, z
        RTOR    \b, \c
        RTOR    \y, \z
        IBXEQ   \set, r0, r0, either\@
        RTOR    \a, \c
        RTOR    \x, \z
either\@:
        .endm

        .macro  quotient_in set, a, b, c
        DIVS    \a, \b, \c
        .endm

; ---- Segments ----------------------------------------------------------------

        .macro  divide_unless_parallel a, b, c, out
        ABS     \b, \c
        CFPLT   \c, tiny, \out
        DIVS    \a, \b, \c
        .endm

        .macro  parallel_rays label, end
\label:
        .endm

        .macro  inside_if_not_less_number a, k, miss
        CFPLT   \a, \k, \miss
        RTOR    minus_big, tin
        RTOR    big, tout
        .endm

        .macro  half_space_segment a, d, from, to, miss
        RTOR    minus_big, \from
        RTOR    big, \to
        ABS     \d, t1
        CFPLT   t1, tiny, space_parallel\@
        DIVS    \a, \d, \a
        CFPLT   \d, r0, space_enters\@
        RTOR    \a, \to
        BIM     space_found\@
space_enters\@:
        RTOR    \a, \from
        BIM     space_found\@
space_parallel\@:
        CFPLT   \a, r0, \miss
space_found\@:
        .endm

        .macro  leave_empty miss
        CFPLT   tout, tin, \miss
        .endm

        .macro  leave_on_half_line a, k, t, first=one
        CFPLT   \a, \k, enters\@
        RTOR    minus_big, tin
        RTOR    \t, tout
        leave_kernel \first
enters\@:
        RTOR    \t, tin
        RTOR    big, tout
        leave_kernel \first
        .endm

        .macro  point_in set, t
        RTOR    \t, tin
        RTOR    \t, tout
        .endm

        .macro  slab o, d, low, high, miss
        ABS     \d, t0
        CFPLT   t0, tiny, slab_parallel\@
        DIVS    one, \d, t0
        SUBN    \low, \o, t1
        SUBN    \high, \o, t2
        MPYS    t1, t0, t1
        MPYS    t2, t0, t2
        CFPGE   t2, t1, slab_ordered\@
        RTOR    t1, t3
        RTOR    t2, t1
        RTOR    t3, t2
slab_ordered\@:
        ray_not_below t1, tin
        ray_not_above t2, tout
        CFPLT   tout, tin, \miss
        BIM     slab_end\@
slab_parallel\@:
        CFPLT   \o, \low, \miss
        CFPLT   \high, \o, \miss
slab_end\@:
        .endm

; ---- Quadratics --------------------------------------------------------------

; Registers of the kernels that solve a quadratic, after t9.
        .share  local
        .regs   r58, shift, quad_a, quad_b, quad_c, o_along, d_along, k_along
        .endshare

        .macro  discriminant a, b, c, disc, work
        MPYS    \b, \b, \disc
        MPYS    \a, \c, \work
        SUBN    \disc, \work, \disc
        .endm

        .macro  quadratic_roots a, b, c, disc, first, second, no_first, no_second
        SQRT    \disc, \disc
        ABS     \b, \first
        ADDN    \first, \disc, \disc
        CFPLT   \b, r0, quadratic_signed\@
        SUBN    r0, \disc, \disc
quadratic_signed\@:
        CFPEQ   \disc, r0, \no_second
        DIVS    \c, \disc, \second
        CFPEQ   \a, r0, \no_first
        DIVS    \disc, \a, \first
        .endm

        .macro  sort_roots first, second
        RTOR    \first, tin
        RTOR    \second, tout
        CFPGE   \second, \first, sorted\@
        RTOR    \second, tin
        RTOR    \first, tout
sorted\@:
        .endm

        .macro  closest_approach x0, x1, x2, o0, o1, o2, along, work0, work1
        dot     \x0, \x1, \x2, dx, dy, dz, \along, \work0
        three_by MPYS, \along, dx, dy, dz, \work0, \work1, third
        three   SUBN, \x0, \x1, \x2, \work0, \work1, third, \o0, \o1, \o2
        .endm

        .macro  move_back along
        SUBN    tin, \along, tin
        SUBN    tout, \along, tout
        .endm

        .macro  clear_if_negative disc, a, miss
        CFPGE   \disc, r0, clear_not\@
        CFPGE   \a, r0, \miss
        ADDN    r0, r0, \disc
clear_not\@:
        .endm

        .macro  cone_roots miss
        quadratic_roots quad_a, quad_b, quad_c, t2, t0, t1, cone_one\@, cone_double\@
        sort_roots t0, t1
        BIM     cone_sided\@
cone_one\@:
        SUBN    r0, quad_b, k_along
        RTOR    t1, tin
        RTOR    t1, tout
        BIM     cone_sided\@
cone_double\@:
        DIVS    t2, quad_a, tin
        RTOR    tin, tout
        CFPNE   quad_a, r0, cone_sided\@
        CFPLT   r0, quad_c, \miss
        RTOR    minus_big, tin
        RTOR    big, tout
        RTOR    one, quad_a
cone_sided\@:
        .endm

        .macro  quadric_roots miss
        CFPLT   t2, r0, \miss
        quadratic_roots quad_a, quad_b, quad_c, t2, t0, t1, quadric_one\@, quadric_double\@
        sort_roots t0, t1
        BIM     quadric_crossed\@
quadric_double\@:
        CFPEQ   quad_a, r0, \miss
        DIVS    t2, quad_a, t1
quadric_one\@:
        RTOR    t1, tin
        RTOR    t1, tout
quadric_crossed\@:
        .endm

        .macro  crossings_or_miss
        move_back shift
        .endm

        .macro  quadric_segments
        RTOR    big, t8
        RTOR    minus_big, t9
        CFPLT   t2, r0, solid_uncrossed\@
        quadratic_roots quad_a, quad_b, quad_c, t2, t0, t1, solid_one\@, solid_double\@
        sort_roots t0, t1
solid_two\@:
        move_back shift
        CFPGE   quad_a, r0, solid_stored\@
        RTOR    tin, t7
        RTOR    tout, t8
        RTOR    big, t9
        RTOR    minus_big, tin
        RTOR    t7, tout
        BIM     solid_stored\@
solid_double\@:
        CFPEQ   quad_a, r0, solid_constant\@
        DIVS    t2, quad_a, tin
        RTOR    tin, tout
        BIM     solid_two\@
solid_one\@:
        SUBN    t1, shift, t1
        RTOR    minus_big, tin
        RTOR    t1, tout
        CFPGE   quad_b, r0, solid_stored\@
        RTOR    t1, tin
        RTOR    big, tout
        BIM     solid_stored\@
solid_constant\@:
        RTOR    quad_c, quad_a
solid_uncrossed\@:
        RTOR    big, tin
        RTOR    minus_big, tout
        CFPGE   quad_a, r0, solid_stored\@
        RTOR    minus_big, tin
        RTOR    big, tout
solid_stored\@:
        ES      t7, 2
        STO     [a_segment, t7], t8
        IX      t7, 1
        STO     [a_segment, t7], t9
        .endm

; ---- A cylinder in its own frame ---------------------------------------------

        .macro  sides_unless_along a, least, divisor, along
        CFPLT   \a, \least, \along
        .endm

        .macro  real_root disc, miss
        CFPLT   \disc, r0, \miss
        SQRT    \disc, \disc
        .endm

        .macro  opposite_roots b, root, first, last
        SUBN    r0, \b, \b
        SUBN    \b, \root, \first
        ADDN    \b, \root, \last
        .endm

        .macro  ends_unless_across a, least, d, divisor, along, across
\along:
        ABS     \d, t3
        CFPLT   t3, tiny, \across
        .endm

        .macro  quotient_by a, b, divisor, c
        DIVS    \a, \b, \c
        .endm

        .macro  candidate_within a, k, t
        ABS     \a, \a
        candidate_not_above \a, \k, \t
        .endm

        .macro  candidate_not_above a, k, t
        CFPLT   \k, \a, not_candidate\@
        CFPGE   \t, tin, not_first\@
        RTOR    \t, tin
not_first\@:
        CFPGE   tout, \t, not_candidate\@
        RTOR    \t, tout
not_candidate\@:
        .endm

; ---- A cylinder clipped by planes --------------------------------------------

        .reg    two, m_two
        .reg    surface_in, quad_c
        .reg    surface_out, o_along

        .macro  normalise x0, x1, x2, length, work
        normalise_by one, \x0, \x1, \x2, \length, \work
        .endm

        .macro  unless_parallel length, along
        CFPLT   \length, tiny, \along
        .endm

        .macro  set_within a, k, set, out
        ABS     \a, \a
        CFPLT   \k, \a, \out
        .endm

        .macro  quotient_opposite a, b, c
        SUBN    r0, \a, \a
        DIVS    \a, \b, \c
        .endm

        .macro  half_chord distance, radius, set
        MPYS    \distance, \distance, \distance
        MPYS    \radius, \radius, t8
        SUBN    t8, \distance, \distance
        SQRT    \distance, \distance
        .endm

        .macro  segment_about t, half, set
        ABS     \half, \half
        SUBN    \t, \half, tin
        ADDN    \t, \half, tout
        .endm

        .macro  only_parallel label, end
        BIM     \end
\label:
        .endm

        .macro  inside_if_number_not_less k, a, miss
        CFPLT   \k, \a, \miss
        RTOR    minus_big, tin
        RTOR    big, tout
        .endm

        .macro  record_surface surface, where
        .ifndef CYLINDER_UNRECORDED
        RTOR    \surface, \where
        .endif
        .endm

        .macro  clip p0, p1, p2, q, surface, miss
        three   MPYS, dx, dy, dz, \p0, \p1, \p2, t0, t1, t2
        three   MPYS, ox, oy, oz, \p0, \p1, \p2, t3, t4, t5
        ADDN    t1, t0, t0
        ADDN    t4, t3, t3
        ADDN    t2, t0, t0
        ADDN    t5, t3, t3
        ABS     t0, t1
        ADDN    t3, \q, t3
        CFPLT   t1, tiny, clip_parallel\@
        SUBN    r0, t3, t3
        DIVS    t3, t0, t1
        CFPGE   t0, r0, clip_leaves\@
        CFPGE   tin, t1, clip_done\@
        CFPLT   tout, t1, \miss
        RTOR    t1, tin
        record_surface    \surface, surface_in
        BIM     clip_done\@
clip_leaves\@:
        CFPGE   t1, tout, clip_done\@
        CFPLT   t1, tin, \miss
        RTOR    t1, tout
        record_surface    \surface, surface_out
        BIM     clip_done\@
clip_parallel\@:
        CFPLT   r0, t3, \miss
clip_done\@:
        .endm

        .macro  give_surfaces
        .ifndef CYLINDER_UNRECORDED
        IX      a_primitive, 64 * (P_PATCH_POINT - P_SHAPE)
        STO     [a_primitive], surface_in
        STO     [a_primitive, index_one], surface_out
        .endif
        .endm

        .macro  leave_with_side miss, recorded
        CFPEQ   surface_in, r0, clipped_enters\@
        CFPNE   surface_out, r0, \miss
        RTOR    tout, tin
        BIM     \recorded
clipped_enters\@:
        CFPEQ   surface_out, r0, \recorded
        RTOR    tin, tout
        BIM     \recorded
        .endm
