; roots_scalar.s - computes the roots of a list of polynomials, one after
; another.
;
; It does the same operations in the same order as roots_vector.s, so that the
; roots are equal bit for bit.  roots_records.s describes the data that the host
; writes and reads.

        .include "roots/roots_records.s"
        .include "frame/linkage.s"
        .include "roots/scaling_scalar.s"

        .share  main
        .regs   r12, s0, stride, left, wanted, input, result, at, routine
        .regs   r20, index_minus_one, zero, number
        .endshare
        .regs   r104, one, two, three, four, forty_six, most_above
        .regs   r110, most_exponent, least_exponent, unit, index_one
        .regs   r114, c4, c3, c2, c1, c0, interval_low, interval_high
        .regs   r121, resolution, bound, x_low, size, far, near, at_zero
        .regs   r128, e0, e1, e2, e3, e4, top, degree, k, largest, t0, t1, t2
        .regs   r140, root0, root1, root2, root3, root_count, found

        .data
; Arguments of the solver: five coefficients and the interval, in the order of
; the registers from c4 on, and the roots that it returns.
roots_passed:   .space 8
roots_arguments: .space 5
quartic_list:   .descriptor 5, roots_passed
                .descriptor 3, roots_passed + 64 * 5
                .descriptor 5, roots_arguments
        .code

        .macro  load_input register
        LOD     [at], \register
        ADDX    at, stride, at
        .endm

; Computes the roots between interval_low and interval_high.
        .macro  call_quartic
        EX      s0, roots_passed
        ELEN    s0, 8
        SWAP    [r0], c4, [s0]
        EX      arguments, quartic_list
        BSAVE   link, [routine]
        EX      s0, roots_arguments
        ELEN    s0, 5
        SWAP    [s0], root0, [r0]
        .endm

        .macro  append root
        MPYS    \root, size, t0
        ADDX    at, stride, at
        STO     [at], t0
        ADDN    found, one, found
        .endm

        .macro  append_counted root, least, done
        CFPLT   root_count, \least, \done
        append  \root
        .endm

; Appends the roots of the solver.  Branches to roots_store when no more are
; wanted.
        .macro  append_found
        append_counted root0, one, roots_none\@
        IBXEQ   wanted, r0, index_one, roots_store
        append_counted root1, two, roots_none\@
        append_counted root2, three, roots_none\@
        append_counted root3, four, roots_none\@
roots_none\@:
        .endm

        .entry  roots_begin
        .kernel quartic
roots_begin:
        EX      s0, scaling_constants
        ELEN    s0, SCALING_CONSTANTS
        SWAP    [s0], one, [r0]
        ES      index_minus_one, -1
        ADDN    r0, r0, zero
        RTOR    zero, resolution
        EX      s0, roots_polynomials
        LOD     [s0], left
        EX      s0, roots_wanted
        LOD     [s0], wanted
        EX      s0, roots_inputs
        LOD     [s0], input
        EX      s0, roots_results
        LOD     [s0], result
        SHIFTI  left, 6, stride
        EX      routine, solve_quartic_all
        IBXNE   wanted, r0, index_one, roots_all
        EX      routine, solve_quartic
roots_all:
        IBXLE   left, r0, r0, roots_end
roots_next:
        RTOR    input, at
        load_input c4
        load_input c3
        load_input c2
        load_input c1
        load_input c0
        load_input bound
        RTOR    result, at
        RTOR    zero, found
        scale

        CFPGE   bound, r0, roots_above  ; below zero
        SUBN    r0, far, interval_low
        CFPGE   interval_low, x_low, roots_from
        RTOR    x_low, interval_low
roots_from:
        SUBN    r0, near, interval_high
        call_quartic
        append_found
        IBXEQ   at_zero, r0, r0, roots_above
        append  zero
        IBXEQ   wanted, r0, index_one, roots_store
roots_above:
        RTOR    near, interval_low
        CFPGE   interval_low, x_low, roots_to
        RTOR    x_low, interval_low
roots_to:
        RTOR    far, interval_high
        call_quartic
        append_found
        BIM     roots_store
roots_refused:
        SUBN    r0, one, found
roots_store:
        STO     [result], found
        IX      input, 64
        IX      result, 64
        IBXNE   left, index_minus_one, r0, roots_next, left
roots_end:
        EXIT
        .endkernel

        .include "roots/quartic_scalar.s"
