; quartic_vector.s - computes the real roots of many polynomials, each in an
; interval.
;
;       c4 t^4 + c3 t^3 + c2 t^2 + c1 t + c0 = 0,   low < t <= high
;
; In:   s0-s4 = descriptors of c4, c3, c2, c1, c0 (leading zeros make a cubic,
;       a quadratic and so on), s5, s6 = of low, high, all of one length of
;       at most QUEUE; a lane whose low is not below its high has no roots.
;       s7 = resolution, one number: roots are within the larger of 2^-41 |t|
;       and the resolution.  With resolution 0 even the smallest roots are
;       relatively accurate.
; Call: BSAVE link_inner, to solve_quartic for the first root of each
;       polynomial, to solve_quartic_all for all, to solve_quartic_until for the
;       first that is accepted, to solve_quartic_signs for all by changes of
;       sign alone (macro call_quartic).  For solve_quartic_until s8 = the
;       address of a routine, called by BSAVE s9 with the roots of an interval
;       before the next interval is processed: q_t = the roots, q_at = the
;       indices of their lanes, q_u = their number.  It returns q_bits = the
;       accepted ones, and may change s0-s7, the vectors q_a .. q_d and the bit
;       vector q_change (lengths must be set first) and the registers outside
;       the solver.
; Out:  root0 = the smallest root, 1e30 if there is none; root_count = the
;       number of roots, as a float.  After solve_quartic_all also root1, root2,
;       root3, ascending; a place not below root_count is undefined, after
;       solve_quartic_signs 1e30.  All as long as c4.
; Changed: s0-s9, r68, r69, r76-r79, r113-r115.  The solver saves and restores
;       its other registers, r116-r200.  The inputs are only read.
;
; Method (the paper's: slope and curvature determine the intervals that can
; contain a root, modified regula falsi refines it):
;
;   bends    the roots of f'', a t^2 + 2 b t + c = 0, in closed form:
;            q = -(b + sign(b) sqrt(b^2 - a c)), q/a and c/q; one bend where
;            b^2 - a c is 0 within the tolerance.  Clamped to the interval.
;   knots    the roots of f' between low, the bends and high: at most one
;            between two of them, if the signs of f' differ
;   roots    the roots of f between low, the knots and high, in the same way
;
; The intervals are processed in order from low on, so that nothing is computed
; after the first accepted root of a polynomial.  Signs decide; 0 is positive.
; A value also counts as 0 if |f(t)| <= 2^-44 sum |c_i| |t|^i, the rounding
; error in 47 bits:
;
;   - A knot at which f is 0 is a root, double or triple, and the intervals on
;     both sides have no other.  The same rule applies to high.  If f is 0 at
;     low, low itself is not a root, and its interval has no other root.
;   - If f is 0 at successive knots, the first is the root of the cluster.
;   - A bend at which f' is 0 is a knot, by the same test.
;
; So double and triple roots are reported once, and a root at low is not
; reported.  Knots need not be sharp: an error of 2^-28 changes f there by 2^-56
; of its terms.  A knot that is a root is sharpened by a Newton step on f'.
;
; Roots by signs alone have no tolerance (signs.s).
;
; Lanes that have their root, or that never had an interval, are removed by
; compression when fewer than half are left.  The refinement has a loop of its
; own (falsi_vector.s).
; Source: the paper; the project's notes on ray tracing, 3.

        .include "roots/quartic_constants.s"
        .include "roots/falsi_vector.s"
        .include "roots/values.s"
        .include "roots/signs.s"
        .include "forms.s"
        vector_form solver_, q_sign

; Registers of the caller.  r68, r69, r113, r114 are scratch here and not saved.
        .regs   r68, q_table_at, q_image_at
        .regs   r76, root0, root1, root2, root3
        .regs   r113, q_save_at, q_length
        .reg    root_count, r115

; Vectors, then bit vectors: the order of solver_bases.
        .share                          ; saved and restored
        .regs   r116, q_s3, q_s2, q_s1                      ; of f', with q_c1
        .regs   r119, q_bend1, q_bend2                      ; f'' = 0
        .regs   r121, q_left_slope, q_knot, q_knot_f, q_most_value, q_most_slope
        .regs   r126, q_position, q_count, q_lane
        .regs   r129, q_right_slope, q_next, q_next_f, q_size, q_root
        .regs   r134, q_k4, q_k3, q_k2, q_k1, q_k0          ; lanes in the loop
        .regs   r139, q_a, q_fa, q_b, q_fb, q_x, q_fx
        .regs   r145, q_w, q_s, q_d, q_t, q_answer, q_at
        .equ    QUARTIC_VECTORS, 35
        .regs   r151, q_alive, q_left_flat, q_right_flat, q_knot_touch
        .regs   r155, q_next_touch, q_need, q_sign
        .regs   r158, q_active, q_b_sign, q_small, q_change, q_x_sign, q_done
        .regs   r164, q_bits, q_changed
        .equ    QUARTIC_BITS, 15

; The same by numbers: kept from interval to interval; of one interval; of one
; step in falsi_vector.s.
        .regs   q_s3, kept0, kept1, kept2, kept3, kept4, kept5, kept6
        .regs   q_knot_f, kept7, kept8, kept9, kept10, kept11
        .regs   q_right_slope, interval0, interval1, interval2, interval3, interval4
        .regs   q_alive, flag0, flag1, flag2, flag3, flag4, flag5, flag6
        .regs   q_x, loop0, loop1, loop2, loop3, loop4, loop5, loop6
        .regs   q_small, loop_bits0, loop_bits1, loop_bits2, loop_bits3, loop_bits4, loop_bits5

; Constants, then registers without an initial value.
        .regs   r166, q_one, q_half, q_three_halves, q_three, q_four
        .regs   r171, q_wide, q_tolerance, q_close, q_knot_close, q_polish
        .regs   r176, q_least, q_none, q_index_one, q_falsi_steps, q_all_steps
        .regs   r181, q_c4, q_c3, q_c2, q_c1, q_c0, q_low, q_high
        .regs   r188, q_resolution, q_lanes, q_want, q_left, q_result
        .regs   q_c4, input0, input1, input2, input3, input4, input5, input6, input7
        .regs   r193, q_alive_count, q_active_count, q_finished, q_loop
        .regs   r197, q_steps, q_u, q_link, q_target
        .endshare
        .equ    QUARTIC_REGISTERS, 85
        .equ    QUARTIC_DESCRIBED, QUARTIC_VECTORS + QUARTIC_BITS
        .equ    QUARTIC_LOADED, QUARTIC_DESCRIBED + QUARTIC_CONSTANTS

        .equ    QUARTIC_BIT_WORDS, (QUEUE + 63) / 64

        .data
solver_bases:
        vector_bases QUARTIC_VECTORS, solver_store, QUARTIC_BITS, solver_bits
solver_image:
        .space  QUARTIC_DESCRIBED
        quartic_constants
solver_save:   .space QUARTIC_REGISTERS
solver_bits:   .space QUARTIC_BIT_WORDS * QUARTIC_BITS
        .align  64
solver_store:  .space QUEUE * QUARTIC_VECTORS
solver_order:  .space QUEUE                    ; 0, 1, 2, ...
solver_inputs: .space QUEUE * 7                ; compressed inputs
solver_roots:  .space QUEUE * 5
        .code

        .macro  call_quartic routine, c4, c3, c2, c1, c0, low, high, resolution
        RTOR    \c4, s0
        RTOR    \c3, s1
        RTOR    \c2, s2
        RTOR    \c1, s3
        RTOR    \c0, s4
        RTOR    \low, s5
        RTOR    \high, s6
        ADDN    \resolution, r0, s7
        BSAVE   link_inner, [\routine]
        .endm

; Clamps bends outside the interval, and indefinite ones, to its ends.
        .macro  clamp x
        CMPGEV  [\x], [q_low], [q_sign]
        VTOV    [q_low], [\x] ?! [q_sign]
        CMPLTV  [q_high], [\x], [q_sign]
        VTOV    [q_high], [\x] ? [q_sign]
        .endm

; Values of the lanes in the loop.
        .macro  quartic_value x, fx
        quartic_polynomial \x, \fx, q_k4, q_k3, q_k2, q_k1, q_k0
        .endm

        .macro  cubic_value x, fx
        cubic_polynomial \x, \fx, q_k3, q_k2, q_k1, q_k0
        .endm

        .macro  cubic_compress bits
        .rept   4
        CPSV    [q_k\+], [q_k\+] ? [\bits]
        .endr
        .endm

        .macro  quartic_compress bits
        CPSV    [q_k4], [q_k4] ? [\bits]
        cubic_compress \bits
        .endm

; Computes the value at x, and the lanes in which it is 0 within the tolerance.
; The sum of the magnitudes is at most that at the end of the interval that is
; farther from 0 (most).  It is computed only if a value is that small.
        .macro  quartic_size x, size
        MPYSV   |[\x]|, |[q_c4]|, [\size]
        ADDNV   |[q_c3]|, [\size], [\size]
        size_step \x, \size, q_c2
        size_step \x, \size, q_c1
        size_step \x, \size, q_c0
        MPYSV   [\size], q_tolerance, [\size]
        .endm

        .macro  cubic_size x, size
        MPYSV   |[\x]|, |[q_s3]|, [\size]
        ADDNV   |[q_s2]|, [\size], [\size]
        size_step \x, \size, q_s1
        size_step \x, \size, q_c1
        MPYSV   [\size], q_tolerance, [\size]
        .endm

        .macro  size_step x, size, c
        MPYSV   |[\x]|, [\size], [\size]
        ADDNV   |[\c]|, [\size], [\size]
        .endm

        .macro  is_zero x, fx, most, zero, sum
        CMPGEV  [\most], |[\fx]|, [\zero]
        ANDB    [\zero], [q_alive], [\zero]
        count_lanes \zero, is_zero\@
        \sum    \x, q_size
        CMPGEV  [q_size], |[\fx]|, [\zero]
is_zero\@:
        .endm

        .macro  quartic_at x, fx, zero
        value_at \x, \fx
        is_zero \x, \fx, q_most_value, \zero, quartic_size
        .endm

        .macro  cubic_at x, fx, zero
        slope_at \x, \fx
        is_zero \x, \fx, q_most_slope, \zero, cubic_size
        .endm

; bits = the lanes in which the signs of two values differ; 0 is positive.
        .macro  signs_differ f, g, bits
        CMPGEV  [\f], r0, [q_sign]
        CMPGEV  [\g], r0, [\bits]
        XORB    [q_sign], [\bits], [\bits]
        .endm

; Copies the lanes of bits and their brackets into the loop.
        .macro  take into, from, bits
        CPSV    [\from], [\into] ? [\bits]
        .endm

        .macro  take_bracket a, fa, b, fb, bits
        take    q_a, \a, \bits
        take    q_fa, \fa, \bits
        take    q_b, \b, \bits
        take    q_fb, \fb, \bits
        describe q_target, solver_order, q_lanes
        take    q_at, q_target, \bits
        .endm

        .macro  count_lanes bits, none
        if_none \bits, q_u, \none
        .endm

; The operations of signs.s.
        .macro  if_signs_differ f, g, same
        signs_differ \f, \g, q_need
        ANDB    [q_need], [q_alive], [q_need]
        count_lanes q_need, \same
        .endm

        .macro  move    new, old
        exchange \new, \old
        .endm

        .macro  append_root
        CNTOB   [q_need], q_u
        CPSV    [q_root], [q_t] ? [q_need]
        give_place
        .endm

; Keeps only the lanes of q_alive.  compress_input moves an input of the caller
; to a vector of the solver.
        .macro  compress_vector vector
        CPSV    [\vector], [\vector] ? [q_alive]
        .endm

        .macro  compress_input vector, number
        EX      q_target, solver_inputs + 64 * QUEUE * \number
        CPSV    [\vector], [q_target] ? [q_alive]
        RTOR    q_target, \vector
        .endm

        .macro  compress_inputs
        compress_input q_c4, 0
        compress_input q_c3, 1
        compress_input q_c2, 2
        compress_input q_c1, 3
        compress_input q_c0, 4
        compress_input q_high, 5
        compress_vector q_lane
        .endm

        .macro  compressed
        RTOR    q_alive_count, q_lanes
        .rept   5
        lengthen q_lanes, interval\+
        .endr
        .rept   7
        lengthen q_lanes, flag\+
        .endr
        EQVB    [q_alive], [q_alive], [q_alive]
        .endm

; Branches to wide if at least half of the lanes are alive.
        .macro  if_half_alive wide
        ADDX    q_alive_count, q_alive_count, q_u
        IBXGE   q_u, r0, q_lanes, \wide
        .endm

; Appends the roots q_t to those of the lanes of q_need.
        .macro  give_place
        CPSV    [q_position], [q_at] ? [q_need]
        VTOVX   [q_at], [q_t], [root0]
        EX      q_target, QUEUE
        ADDXV   [q_position], q_target, [q_position] ? [q_need]
        ADDNV   [q_count], q_one, [q_count] ? [q_need]
        .endm

; Stores the roots q_root of the lanes of q_need.
        .macro  give_roots
        count_lanes q_need, give_none\@
        CPSV    [q_root], [q_t] ? [q_need]
        IBXEQ   q_want, r0, q_index_one, give_one\@
        give_place
        BIM     give_none\@
give_one\@:
        CPSV    [q_lane], [q_at] ? [q_need]
        IBXEQ   s8, r0, r0, give_first\@
        EX      q_target, solver_show
        BSAVE   q_link, [q_target]
give_first\@:
        VTOVX   [q_at], [q_t], [root0]
        VTOVX   [q_at], q_one, [root_count]
        SUBX    q_alive_count, q_u, q_alive_count
        IBXEQ   q_alive_count, r0, r0, solver_end
        ANDNB   [q_alive], [q_need], [q_alive]
give_none\@:
        .endm

; A knot at which f is 0 is a double root, but only as sharp as knots are.  A
; Newton step on f' sharpens it, if the step is short and stays in the interval.
        .macro  polish
        lengthen q_lanes, q_w
        lengthen q_lanes, q_s
        lengthen q_lanes, q_d
        newton_on_slope
        LINKV
        MPYSV   |[q_next]|, q_polish, [q_d]
        ADDNV   [q_d], q_resolution, [q_d]
        SUBNV   [q_next], [q_w], [q_s]
        keep_where CMPGEV, [q_d], |[q_w]|, q_sign, q_bits
        keep_where CMPLTV, [q_knot], [q_s], q_sign, q_bits
        keep_where CMPGEV, [q_high], [q_s], q_sign, q_bits
        VTOV    [q_s], [q_root] ? [q_sign]
        .endm

; Refines the roots of the lanes of q_need, between knot and next.
        .macro  refine_value
        take_bracket q_knot, q_knot_f, q_next, q_next_f, q_need
        .rept   5
        take    q_k\+, q_c\+, q_need
        .endr
        RTOR    q_root, q_result
        EX      q_target, refine_quartic
        BSAVE   q_link, [q_target]
        .endm

; Computes the roots of f in (knot, next]; at_knot = 0: next is the end of the
; interval.
        .macro  search_values at_knot
        quartic_at q_next, q_next_f, q_next_touch
        signs_differ q_knot_f, q_next_f, q_need
        ANDB    [q_need], [q_alive], [q_need]
        ANDNB   [q_need], [q_knot_touch], [q_need]
        ANDNB   [q_need], [q_next_touch], [q_need]
        VTOV    [q_next], [q_root]
        count_lanes q_need, search_touch\@
        refine_value
search_touch\@:
        ANDNB   [q_next_touch], [q_knot_touch], [q_sign]
        ANDB    [q_sign], [q_alive], [q_sign]
        ORB     [q_need], [q_sign], [q_need]
        .if     \at_knot
        count_lanes q_sign, search_found\@
        lengthen q_lanes, q_bits
        polish
search_found\@:
        .endif
        give_roots
        exchange q_next, q_knot
        exchange q_next_f, q_knot_f
        exchange q_next_touch, q_knot_touch
        .endm

; Refines the next knots of the lanes of q_need, between left and right.
        .macro  refine_slope right
        take_bracket q_left, q_left_slope, \right, q_right_slope, q_need
        take    q_k3, q_s3, q_need
        take    q_k2, q_s2, q_need
        take    q_k1, q_s1, q_need
        take    q_k0, q_c1, q_need
        RTOR    q_next, q_result
        EX      q_target, refine_cubic
        BSAVE   q_link, [q_target]
        .endm

; The roots of f' in (left, right] are the next knots.  A right end at which f'
; is 0 is a knot itself if it is a bend.
        .macro  search_slope right, bend
        cubic_at \right, q_right_slope, q_right_flat
        signs_differ q_left_slope, q_right_slope, q_need
        ANDB    [q_need], [q_alive], [q_need]
        ANDNB   [q_need], [q_left_flat], [q_need]
        ANDNB   [q_need], [q_right_flat], [q_need]
        VTOV    [q_knot], [q_next]
        .if     \bend
        VTOV    [\right], [q_next] ? [q_right_flat]
        .endif
        count_lanes q_need, search_flat\@
        refine_slope \right
        BIM     search_knots\@
search_flat\@:
        .if     \bend
        ANDB    [q_right_flat], [q_alive], [q_sign]
        count_lanes q_sign, search_none\@
        .else
        BIM     search_none\@
        .endif
search_knots\@:
        search_values 1
search_none\@:
        exchange q_left_slope, q_right_slope
        exchange q_left_flat, q_right_flat
        if_half_alive search_alive\@
        compress_inputs
        .rept   10
        compress_vector kept\+
        .endr
        CPSB    [q_left_flat], [q_left_flat] ? [q_alive]
        CPSB    [q_knot_touch], [q_knot_touch] ? [q_alive]
        compressed
search_alive\@:
        RTOR    \right, q_left
        .endm

; Loads the inputs, selects the lanes that have an interval, and computes the
; derivative; no root is found yet: the first places root vectors are set to
; 1e30.
        .macro  enter_search places
        LTOR    s0, q_length
        lengthen_table solver_bases, solver_image, QUARTIC_DESCRIBED, q_length, q_table_at, q_image_at, q_length
        ELEN    q_image_at, QUARTIC_LOADED
        EX      q_save_at, solver_save
        ELEN    q_save_at, QUARTIC_REGISTERS
        SWAP    [q_image_at], q_s3, [q_save_at]
        .rept   8
        RTOR    s\+, input\+
        .endr
        LTOR    q_c4, q_lanes
        RTOR    s9, q_want
        describe root0, solver_roots, q_lanes
        address_of root0, QUEUE, root1
        address_of root1, QUEUE, root2
        address_of root2, QUEUE, root3
        address_of root3, QUEUE, root_count
        .rept   \places
        VTOV    q_none, [root\+]
        .endr
        VTOV    r0, [root_count]
        INTVLV  r0, q_index_one, [q_lane]
        describe q_target, solver_order, q_lanes
        VTOV    [q_lane], [q_target]

        CMPLTV  [q_low], [q_high], [q_alive]
        if_none q_alive, q_alive_count, solver_end
        if_half_alive enter_alive\@
        compress_inputs
        compress_input q_low, 6
        .rept   12
        lengthen q_alive_count, kept\+
        .endr
        compressed
enter_alive\@:
        VTOV    [q_lane], [q_position]
        VTOV    r0, [q_count]
        derive
        .endm

; Computes the bends, with a = q_next, b = q_right_slope, b^2 = q_knot,
; a c = q_knot_f.
        .macro  find_bends
        MPYSV   [q_s3], q_three_halves, [q_next]
        MPYSV   [q_c3], q_three_halves, [q_right_slope]
        MPYSV   [q_right_slope], [q_right_slope], [q_knot]
        MPYSV   [q_next], [q_c2], [q_knot_f]
        SUBNV   [q_knot], [q_knot_f], [q_root]
        LINKV
        ADDNV   |[q_knot_f]|, [q_knot], [q_knot]
        MPYSV   [q_knot], q_tolerance, [q_knot]
        CMPGEV  [q_knot], |[q_root]|, [q_need]
        VTOV    r0, [q_root] ? [q_need]
        CMPGEV  [q_root], r0, [q_left_flat]
        SQRTV   [q_root], [q_root] ? [q_left_flat]
        CMPLTV  [q_right_slope], r0, [q_sign]
        VTOV    -[q_root], [q_root] ? [q_sign]
        ADDNV   [q_right_slope], [q_root], [q_root]
        SUBNV   r0, [q_root], [q_root]
        DIVSV   [q_root], [q_next], [q_bend1]
        DIVSV   [q_c2], [q_root], [q_bend2]
        VTOV    [q_bend1], [q_bend2] ? [q_need]
        VTOV    [q_low], [q_bend1] ?! [q_left_flat]
        VTOV    [q_low], [q_bend2] ?! [q_left_flat]
        clamp   q_bend1
        clamp   q_bend2
        CMPLTV  [q_bend2], [q_bend1], [q_need]
        VTOV    [q_bend1], [q_root]
        VTOV    [q_bend2], [q_bend1] ? [q_need]
        VTOV    [q_root], [q_bend2] ? [q_need]
        .endm

        .kernel root_solver
solve_quartic_all:
        ES      s9, 4
        BIM     solver_begin
solve_quartic:
        ES      s8, 0
solve_quartic_until:
        ES      s9, 1
solver_begin:
        enter_search 1
        ABSV    [q_low], [q_root]
        CMPLTV  [q_root], |[q_high]|, [q_sign]
        ABSV    [q_high], [q_root] ? [q_sign]
        quartic_size q_root, q_most_value
        cubic_size q_root, q_most_slope
        find_bends
        RTOR    q_low, q_left
        cubic_at q_low, q_left_slope, q_left_flat
        VTOV    [q_low], [q_knot]
        quartic_at q_knot, q_knot_f, q_knot_touch
        search_slope q_bend1, 1
        search_slope q_bend2, 1
        search_slope q_high, 0
        VTOV    [q_high], [q_next]
        search_values 0
        IBXEQ   q_want, r0, q_index_one, solver_end
        VTOVX   [q_lane], [q_count], [root_count]
solver_end:
        load_from q_save_at, QUARTIC_REGISTERS, q_s3
        BIM     0, link_inner

solve_quartic_signs:
        enter_search 4
        find_bends
        search_signs
        VTOVX   [q_lane], [q_count], [root_count]
        LTOR    root0, q_u
        lengthen q_u, q_sign
        solver_not_below root0, root1
        solver_not_below root1, root2
        solver_not_below root2, root3
        BIM     solver_end

; Passes the roots q_t of the lanes of q_need to the caller's routine; only the
; accepted ones remain.
solver_show:
        lengthen q_u, q_bits
        BSAVE   s9, [s8]
        MRGB    [q_bits], [q_bits], [q_sign] ? [q_need]
        ANDB    [q_sign], [q_need], [q_need]
        CPSV    [q_t], [q_t] ? [q_bits]
        CPSV    [q_at], [q_at] ? [q_bits]
        CNTOB   [q_bits], q_u
        BIM     0, q_link

        refine  refine_quartic, quartic_value, quartic_compress, q_close
        refine  refine_cubic, cubic_value, cubic_compress, q_knot_close
        .endkernel
