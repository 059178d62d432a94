; quartic_scalar.s - computes the real roots of one polynomial in an interval.
;
;       CALL SOLVE_QUARTIC (COEFFICIENTS, INTERVAL, ROOTS)
;       CALL SOLVE_QUARTIC_ALL (COEFFICIENTS, INTERVAL, ROOTS)
;       CALL SOLVE_QUARTIC_UNTIL (COEFFICIENTS, INTERVAL, ROOTS)
;       CALL SOLVE_QUARTIC_SIGNS (COEFFICIENTS, INTERVAL, ROOTS)
;
; COEFFICIENTS = c4, c3, c2, c1, c0 (5 words) of c4 t^4 + ... + c0; leading
; zeros make a cubic, a quadratic and so on.
; INTERVAL = low, high, resolution (3 words): roots low < t <= high, within the
; larger of 2^-41 |t| and the resolution.  With resolution 0 even the smallest
; roots are relatively accurate.
; ROOTS = up to four roots, ascending, and their number (5 words).
; SOLVE_QUARTIC stops at the first root.  If there is none the first word is
; 1e30; the words after the number of roots are undefined.
; SOLVE_QUARTIC_UNTIL returns one root, the first that is accepted.  The caller
; puts the address of a routine into fourth.  The routine receives each root in
; q_answer before the next is computed.  It ends by BIM solver_accept, or by
; BIM 0, q_link to get the next one, and may change r82-r92 (q_a .. q_u) and the
; registers outside the solver.
; SOLVE_QUARTIC_SIGNS returns all roots, by changes of sign alone; the words
; after the number of roots are 1e30.
;
; Method and order of the operations are those of quartic_vector.s.  An interval
; is left at the first test that shows no root, and the computation ends at the
; first accepted root.
; Registers: local ones as in linkage.s, r32-r98, saved and restored; third and
; fourth are in use until the end.

        .include "roots/quartic_constants.s"
        .include "roots/falsi_scalar.s"
        .include "roots/values.s"
        .include "roots/signs.s"
        .include "forms.s"
        scalar_form solver_

        .share  local
        .regs   r32, q_one, q_half, q_three_halves, q_three, q_four
        .regs   r37, q_wide, q_tolerance, q_close, q_knot_close, q_polish
        .regs   r42, q_least, q_none, q_index_one, q_falsi_steps, q_all_steps
        .regs   r47, q_coefficients, q_interval, q_roots    ; the arguments
        .regs   r50, q_c4, q_c3, q_c2, q_c1, q_c0           ; of f
        .regs   r55, q_low, q_high, q_resolution
        .regs   r58, q_m4, q_m3, q_m2, q_m1, q_m0           ; magnitudes
        .regs   r63, q_s3, q_s2, q_s1                       ; of f', with q_c1
        .regs   r66, q_n3, q_n2, q_n1                       ; magnitudes
        .regs   r69, q_bend1, q_bend2                       ; f'' = 0
        .regs   r71, q_left, q_left_slope, q_left_flat      ; at the left end
        .regs   r74, q_right_slope, q_right_flat
        .regs   r76, q_knot, q_knot_f, q_knot_touch         ; at the knot
        .regs   r79, q_next, q_next_f, q_next_touch
        .regs   r82, q_a, q_fa, q_b, q_fb, q_x, q_fx        ; the bracket
        .regs   r88, q_w, q_s, q_d, q_t, q_u                ; work
        .regs   r93, q_answer, q_steps, q_kept, q_link, q_refine
        .reg    q_count, r98
        .equ    QUARTIC_REGISTERS, 67
        .regs   third, q_want, q_accept         ; also fourth
        .endshare
        .share  local
        .reg    q_last, r78             ; previous root; replaces q_knot_touch
        .endshare

        .data
solver_image:  quartic_constants
solver_save:   .space QUARTIC_REGISTERS
        .code

; fx = value at x; zero = 1 if it is within the tolerance of the sum of the
; magnitudes.  Two chains of operations are interleaved to hide their latencies.
        .macro  one_step x, fx, c, m
        MPYS    \fx, \x, \fx
        MPYS    q_t, q_u, q_t
        ADDN    \fx, \c, \fx
        ADDN    \m, q_t, q_t
        .endm

        .macro  is_zero fx, zero
        ABS     \fx, q_u
        MPYS    q_t, q_tolerance, q_t
        ES      \zero, 1
        CFPGE   q_t, q_u, is_zero\@
        ES      \zero, 0
is_zero\@:
        .endm

        .macro  quartic_at x, fx, zero
        ABS     \x, q_u
        RTOR    q_c4, \fx
        RTOR    q_m4, q_t
        one_step \x, \fx, q_c3, q_m3
        one_step \x, \fx, q_c2, q_m2
        one_step \x, \fx, q_c1, q_m1
        one_step \x, \fx, q_c0, q_m0
        is_zero \fx, \zero
        .endm

        .macro  cubic_at x, fx, zero
        ABS     \x, q_u
        RTOR    q_s3, \fx
        RTOR    q_n3, q_t
        one_step \x, \fx, q_s2, q_n2
        one_step \x, \fx, q_s1, q_n1
        one_step \x, \fx, q_c1, q_m1
        is_zero \fx, \zero
        .endm

; Branches to same if two values have the same sign; 0 is positive.
        .macro  if_signs_differ f, g, same
        CFPGE   \f, r0, signs_above\@
        CFPGE   \g, r0, signs_differ\@
        BIM     \same
signs_above\@:
        CFPGE   \g, r0, \same
signs_differ\@:
        .endm

        .macro  clamp x
        solver_not_below q_low, \x
        solver_not_above q_high, \x
        .endm

; Sharpens a double root by one Newton step on f' (quartic_vector.s).
        .macro  polish
        newton_on_slope
        ABS     q_next, q_d
        MPYS    q_d, q_polish, q_d
        ADDN    q_d, q_resolution, q_d
        SUBN    q_next, q_w, q_s
        ABS     q_w, q_w
        CFPGE   q_d, q_w, polish_short\@
        BIM     polish_end\@
polish_short\@:
        CFPLE   q_s, q_knot, polish_end\@
        CFPGT   q_s, q_high, polish_end\@
        RTOR    q_s, q_answer
polish_end\@:
        .endm

; Stores or passes the root q_answer.  Branches to more if more roots are
; wanted.
        .macro  take_root more
        IBXNE   q_accept, r0, r0, take_shown\@
        STO     [q_roots, q_count], q_answer
        IBXEQ   q_count, q_index_one, q_want, solver_end, q_count
        BIM     \more
take_shown\@:
        BSAVE   q_link, [q_accept]
        BIM     \more
        .endm

; Refines the root between knot and next.
        .macro  refine_value
        RTOR    q_knot, q_a
        RTOR    q_knot_f, q_fa
        RTOR    q_next, q_b
        RTOR    q_next_f, q_fb
        EX      q_refine, refine_quartic
        BSAVE   q_link, [q_refine]
        .endm

; Computes the root of f in (knot, next], if there is one; knot := next.
; at_knot = 0:  next is the end of the interval.
        .macro  search_values at_knot
        CFPEQ   q_next, q_knot, search_none\@
        quartic_at q_next, q_next_f, q_next_touch
        IBXNE   q_next_touch, r0, r0, search_touch\@
        IBXNE   q_knot_touch, r0, r0, search_move\@
        if_signs_differ q_knot_f, q_next_f, search_move\@
        refine_value
        take_root search_move\@
search_touch\@:
        IBXNE   q_knot_touch, r0, r0, search_move\@
        RTOR    q_next, q_answer
        .if     \at_knot
        polish
        .endif
        take_root search_move\@
search_move\@:
        RTOR    q_next, q_knot
        RTOR    q_next_f, q_knot_f
        RTOR    q_next_touch, q_knot_touch
search_none\@:
        .endm

; Refines the next knot, between left and right.
        .macro  refine_slope right
        RTOR    q_left, q_a
        RTOR    q_left_slope, q_fa
        RTOR    \right, q_b
        RTOR    q_right_slope, q_fb
        EX      q_refine, refine_cubic
        BSAVE   q_link, [q_refine]
        RTOR    q_answer, q_next
        .endm

; The root of f' in (left, right], if there is one, is the next knot.  A right
; end at which f' is 0 is a knot itself if it is a bend.
        .macro  search_slope right, bend
        cubic_at \right, q_right_slope, q_right_flat
        .if     \bend
        RTOR    \right, q_next
        IBXNE   q_right_flat, r0, r0, search_knot\@
        .else
        IBXNE   q_right_flat, r0, r0, search_flat\@
        .endif
        IBXNE   q_left_flat, r0, r0, search_flat\@
        if_signs_differ q_left_slope, q_right_slope, search_flat\@
        refine_slope \right
search_knot\@:
        search_values 1
search_flat\@:
        RTOR    \right, q_left
        RTOR    q_right_slope, q_left_slope
        RTOR    q_right_flat, q_left_flat
        .endm

; Loads the arguments; no root is found yet.
        .macro  enter_search
        EX      image_at, solver_image
        ELEN    image_at, QUARTIC_CONSTANTS
        EX      save_at, solver_save
        ELEN    save_at, QUARTIC_REGISTERS
        SWAP    [image_at], q_one, [save_at]
        load_from arguments, 3, q_coefficients
        SWAP    [q_coefficients], q_c4, [r0]
        SWAP    [q_interval], q_low, [r0]
        ES      q_count, 0
        STO     [q_roots], q_none
        .endm

; The operations of signs.s.
        .macro  move    new, old
        RTOR    \new, \old
        .endm

        .macro  append_root
        solver_not_below q_last, q_answer
        RTOR    q_answer, q_last
        STO     [q_roots, q_count], q_answer
        IX      q_count, 1
        .endm

; Computes the magnitudes for the test against 0.
        .macro  find_magnitudes
        ABS     q_c4, q_m4
        ABS     q_c3, q_m3
        ABS     q_c2, q_m2
        ABS     q_c1, q_m1
        ABS     q_c0, q_m0
        ABS     q_s3, q_n3
        ABS     q_s2, q_n2
        ABS     q_s1, q_n1
        .endm

        .macro  find_bends
        MPYS    q_s3, q_three_halves, q_a ; f''/2 = a t^2 + 2 b t + c2
        MPYS    q_c3, q_three_halves, q_b
        MPYS    q_b, q_b, q_t
        MPYS    q_a, q_c2, q_u
        SUBN    q_t, q_u, q_d
        ABS     q_u, q_u
        ADDN    q_t, q_u, q_t
        MPYS    q_t, q_tolerance, q_t
        ABS     q_d, q_u
        RTOR    q_low, q_bend1
        RTOR    q_low, q_bend2
        CFPGE   q_t, q_u, one_bend\@
        CFPLT   q_d, r0, bends\@
        SQRT    q_d, q_s
        CFPGE   q_b, r0, add_root\@
        SUBN    r0, q_s, q_s
add_root\@:
        ADDN    q_b, q_s, q_s
        SUBN    r0, q_s, q_s
        DIVS    q_s, q_a, q_bend1
        DIVS    q_c2, q_s, q_bend2
        BIM     clamp\@
one_bend\@:
        SUBN    r0, q_b, q_s
        DIVS    q_s, q_a, q_bend1
        RTOR    q_bend1, q_bend2
clamp\@:
        clamp   q_bend1
        clamp   q_bend2
        CFPGE   q_bend2, q_bend1, bends\@
        RTOR    q_bend1, q_t
        RTOR    q_bend2, q_bend1
        RTOR    q_t, q_bend2
bends\@:
        .endm

        .kernel root_solver
solve_quartic:
        ES      q_want, 1
        ES      q_accept, 0
        BIM     solver_begin
solve_quartic_all:
        ES      q_want, 4
        ES      q_accept, 0
solve_quartic_until:
solver_begin:
        enter_search
        CFPGE   q_low, q_high, solver_end
        derive
        find_magnitudes
        find_bends
        RTOR    q_low, q_left
        cubic_at q_low, q_left_slope, q_left_flat
        RTOR    q_low, q_knot
        quartic_at q_low, q_knot_f, q_knot_touch
        search_slope q_bend1, 1
        search_slope q_bend2, 1
        search_slope q_high, 0
        RTOR    q_high, q_next
        search_values 0
solver_end:
        IX      q_roots, 64 * 4
        ADDN    q_count, r0, q_count
        STO     [q_roots], q_count
        leave   solver_save, QUARTIC_REGISTERS
solver_accept:
        STO     [q_roots], q_answer
        ES      q_count, 1
        BIM     solver_end

solve_quartic_signs:
        enter_search
        STO     [q_roots, q_index_one], q_none
        ES      q_t, 2
        STO     [q_roots, q_t], q_none
        ES      q_t, 3
        STO     [q_roots, q_t], q_none
        CFPGE   q_low, q_high, solver_end
        derive
        find_bends
        SUBN    r0, q_none, q_last
        search_signs
        BIM     solver_end

        refine  refine_quartic, value_at, q_close
        refine  refine_cubic, slope_at, q_knot_close
        .endkernel
