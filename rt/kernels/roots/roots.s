; roots.s - computes the roots of a list of polynomials.
;
; The form is scalar if the constant SCALAR is defined, otherwise vector.  The
; scalar form computes one polynomial after another.  The vector form computes
; queue after queue of QUEUE polynomials (the last may be shorter).
;
; For each: scale, compute the roots below zero, the root at zero and those
; above zero, in this order, undo the scaling, store.  No interval contains
; zero, so that even the smallest roots are relatively accurate.  If only one
; root is wanted, a polynomial that has one is skipped in the following steps.
;
; All data are in planes with one number per polynomial; roots_polynomials is
; their length.  Results: the number of roots, then the first to the fourth; -1
; for a polynomial whose coefficients cannot be scaled to the machine's
; exponents (scaling.s).

        .equ    MAX_ROOTS, 4
        .record INPUT
        .field  INPUT_COEFFICIENTS, 5   ; c4 c3 c2 c1 c0
        .field  INPUT_BOUND
        .endrecord
        .record RESULT
        .field  RESULT_COUNT
        .field  RESULT_ROOTS, MAX_ROOTS
        .endrecord

        .data
roots_polynomials: .word 0              ; their number, an integer
roots_wanted:      .word 0              ; maximum for each: 1 or 4
roots_inputs:      .word 0              ; address of the first plane
roots_results:     .word 0              ; address of the first plane

; In the order of the registers from one on.
        .equ    SCALING_CONSTANTS, 10
scaling_constants:
        .word   1.0, 2.0, 3.0, 4.0, 46.0
        .word   6900.0                  ; log2 of the largest ratio of a
                                        ; coefficient to the outer two
        .word   28000.0                 ; largest exponent
        .word   -20000.0                ; a coefficient below this is 0
        .word   X'0000 4000 0000 0000'  ; the coefficient 2^46
        .word   1                       ; the integer
        .code

        .include "forms.s"
        .include "frame/common.s"

        .ifdef  SCALAR
; ---- One polynomial ----------------------------------------------------------

        .include "frame/linkage.s"
        .include "roots/quartic_scalar.s"

        .share  main
        .regs   r12, s0, stride, polynomials, wanted, input, result, at, routine
        .reg    index_minus_one, r20
        .endshare
        .regs   r104, one, two, three, four, forty_six, most_above
        .regs   r110, most_exponent, least_exponent, unit, index_one
        .regs   r114, d4, d3, d2, d1, d0, low, high, resolution
        .regs   r122, bound, x_low, size, far, near, at_zero
        .regs   r128, e0, e1, e2, e3, e4, top, degree, k, largest, t0, t1
        .regs   r140, root0, root1, root2, root3, root_count, found
        scalar_form , t0

        .data
; Arguments of the solver: five coefficients and the interval, in the order of
; the registers from d4 on, and the roots that it returns.
roots_passed:   .space 8
roots_arguments: .space 5
quartic_list:   .descriptor 5, roots_passed
                .descriptor 3, roots_passed + 64 * 5
                .descriptor 5, roots_arguments
        .code

; Moves the coefficients down while the last is 0.
        .macro  remove_zeros
        ES      at_zero, 0
        .rept   4
        CFPNE   d0, r0, scale_moved
        RTOR    d1, d0
        RTOR    d2, d1
        RTOR    d3, d2
        RTOR    d4, d3
        clear   d4
        CFPGE   bound, r0, scale_above\+
        ES      at_zero, 1
scale_above\+:
        .endr
        CFPEQ   d0, r0, roots_found     ; all coefficients are zero
scale_moved:
        .endm

        no_code find_present

        .macro  if_present d, label
        CFPEQ   \d, r0, \label
        .endm

        .macro  find_top d, present, e, power
        CFPEQ   \d, r0, find_top\@
        RTOR    \e, top
        RTOR    \power, degree
find_top\@:
        .endm

        .macro  not_below_in present, a, c
        not_below \a, \c
        .endm

        .macro  clear_less_in present, a, k, c
        CFPGE   \a, \k, clear_less\@
        clear   \c
clear_less\@:
        .endm

        .macro  find_refused
        CFPLT   most_above, largest, roots_refused
        absolute_plus k, largest, t0
        CFPLT   most_exponent, t0, roots_refused
        .endm

        .macro  begin_bound end
        clear   x_low
        CFPEQ   bound, r0, \end
        .endm

        no_code end_bound

        .macro  begin_list
        ES      index_minus_one, -1
        clear   resolution
        load_word roots_inputs, input
        load_word roots_results, result
        .endm

        .macro  load_input register
        LOD     [at], \register
        ADDX    at, stride, at
        .endm

        .macro  next_polynomials
        RTOR    input, at
        load_input d4
        load_input d3
        load_input d2
        load_input d1
        load_input d0
        load_input bound
        RTOR    result, at
        clear   found
        .endm

        .macro  if_bound_below label
        CFPGE   bound, r0, \label
        .endm

        .macro  solve_to end
        RTOR    \end, high
        store_words d4, 8, roots_passed, s0
        EX      arguments, quartic_list
        BSAVE   link, [routine]
        load_words roots_arguments, 5, root0
        .endm

        .macro  append root
        times   \root, size, t0
        ADDX    at, stride, at
        STO     [at], t0
        ADDN    found, one, found
        .endm

        .macro  if_at_least least, done
        CFPLT   root_count, \least, \done
        .endm

        .macro  if_more_wanted done
        IBXEQ   wanted, r0, index_one, roots_found
        .endm

        .macro  if_at_zero done
        IBXEQ   at_zero, r0, r0, \done
        .endm

        .macro  leave_out
        IBXEQ   wanted, r0, index_one, roots_found
        .endm

        .macro  store_counts next
        STO     [result], found
        IX      input, 64
        IX      result, 64
        IBXNE   polynomials, index_minus_one, r0, \next, polynomials
        EXIT
roots_refused:
        SUBN    r0, one, found
        BIM     roots_found
        .endm

        .else
; ---- A queue of polynomials --------------------------------------------------

        .regs   r1, link, link_kernel, link_inner
        .regs   r6, s0, s1, s2, s3, s4, s5, s6, s7, s8, s9    ; scratch
        .reg    image_at, s0
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
        vector_form , bits0

        .data
roots_bases:
        vector_bases ROOTS_VECTORS, roots_planes, ROOTS_BITS, roots_bits
roots_descriptors:
        .space  ROOTS_VECTORS
roots_bits_at:
        .space  ROOTS_BITS
roots_bits:     .space ROOTS_BIT_WORDS * ROOTS_BITS
        .align  64
roots_planes:   .space QUEUE * ROOTS_VECTORS
        .code

; Moves the coefficients down while the last is 0.
        .macro  remove_zeros
        .rept   5
        copy    c\+, d\+
        .endr
        CMPEQV  [d0], r0, [at_zero]
        .rept   4
        CMPEQV  [d0], r0, [bits0]
        if_none bits0, number, scale_moved
        then_copy d1, d0
        then_copy d2, d1
        then_copy d3, d2
        then_copy d4, d3
        then_clear d4
        .endr
scale_moved:
        .endm

        .macro  find_present d, present
        CMPNEV  [\d], r0, [\present]
        .endm

        no_code if_present

        .macro  find_top d, present, e, power
        VTOV    [\e], [top] ? [\present]
        VTOV    \power, [degree] ? [\present]
        .endm

        .macro  not_below_in present, a, c
        CMPLTV  [\c], [\a], [bits0]
        ANDB    [bits0], [\present], [bits0]
        then_copy \a, \c
        .endm

        .macro  clear_less_in present, a, k, c
        CMPGEV  [\a], \k, [bits0]
        ANDB    [bits0], [\present], [bits0]
        otherwise_set r0, \c
        .endm

        .macro  find_refused
        CMPLTV  most_above, [largest], [refused]
        absolute_plus k, largest, t0
        CMPLTV  most_exponent, [t0], [bits0]
        ORB     [refused], [bits0], [refused]
        ANDB    [refused], [present0], [refused]
        .endm

        no_code begin_bound

        .macro  end_bound
        CMPEQV  [bound], r0, [bits0]
        then_clear x_low
        VTOV    [far], [x_low] ? [refused]
        .endm

        .macro  begin_list
        ES      first, 0
        .endm

        .macro  describe_plane register
        ADDLEN  plane, batch, \register
        ADDX    plane, stride, plane
        .endm

        .macro  next_polynomials
        SUBX    polynomials, first, batch
        EX      s0, QUEUE
        IBXLE   batch, r0, s0, roots_last
        RTOR    s0, batch
roots_last:
        SHIFTI  first, 6, s1
        load_word roots_inputs, plane
        ADDX    plane, s1, plane
        describe_plane c4
        describe_plane c3
        describe_plane c2
        describe_plane c1
        describe_plane c0
        describe_plane bound
        load_word roots_results, plane
        ADDX    plane, s1, plane
        describe_plane counts
        describe_plane roots
        lengthen_table roots_bases, roots_descriptors, ROOTS_VECTORS + ROOTS_BITS, batch, s0, s1, s2
        load_words roots_descriptors, ROOTS_VECTORS, d4
        load_words roots_bits_at, ROOTS_BITS, at_zero
        INTVLV  r0, index_one, [ray_index]
        clear   found
        .endm

        .macro  if_bound_below label
        CMPLTV  [bound], r0, [bits0]
        if_none bits0, number, \label
        .endm

        .macro  solve_to end
        call_quartic routine, d4, d3, d2, d1, d0, low, \end, r0
        .endm

; Appends the roots, times their scale, in the lanes of bits0.
        .macro  append root
        times   \root, size, t0
        CPSV    [t0], [t1] ? [bits0]
        CPSV    [ray_index], [t2] ? [bits0]
        VTOVX   [t2], [t1], [roots]
        then_raise_index ray_index, polynomials, ray_index
        then_raise found, one, found
        .endm

        .macro  if_at_least least, done
        CMPGEV  [root_count], \least, [bits0]
        if_none bits0, number, \done
        .endm

        .macro  if_more_wanted done
        IBXEQ   wanted, r0, index_one, \done
        .endm

; bits0 = the lanes with a root at zero; x_low is below zero in no lane that is
; left out.
        .macro  if_at_zero done
        leave_out
        CMPLTV  [x_low], r0, [bits0]
        ANDB    [at_zero], [bits0], [bits0]
        ANDB    [bits0], [present0], [bits0]
        .endm

; Gives finished polynomials an empty interval.
        .macro  leave_out
        IBXNE   wanted, r0, index_one, leave_out\@
        CMPGEV  [found], one, [bits0]
        then_copy far, x_low
leave_out\@:
        .endm

        .macro  store_counts next
        SUBN    r0, one, s0
        VTOV    s0, [found] ? [refused]
        copy    found, counts
        ADDX    first, batch, first
        IBXLT   first, r0, polynomials, \next
        .endm
        .endif

; ---- Both --------------------------------------------------------------------

        .include "roots/scaling.s"

        .macro  append_counted root, least, done
        if_at_least \least, \done
        append  \root
        .endm

; Appends the roots of the solver.  Branches to done when there are no more.
        .macro  append_found done
        append_counted root0, one, \done
        if_more_wanted \done
        append_counted root1, two, \done
        append_counted root2, three, \done
        append_counted root3, four, \done
        .endm

        .entry  roots_begin
        .kernel quartic
roots_begin:
        load_words scaling_constants, SCALING_CONSTANTS, one
        load_word roots_polynomials, polynomials
        load_word roots_wanted, wanted
        begin_list
        EX      routine, solve_quartic_all
        IBXNE   wanted, r0, index_one, roots_all
        EX      routine, solve_quartic
roots_all:
        SHIFTI  polynomials, 6, stride
        IBXLE   polynomials, r0, r0, roots_end
roots_next:
        next_polynomials
        scale_polynomials
        if_bound_below roots_above
        negate  far, low
        not_below x_low, low
        negate  near, high
        solve_to high
        append_found roots_at_zero
roots_at_zero:
        if_at_zero roots_above
        clear   low
        append  low
        leave_out
roots_above:
        copy    near, low
        not_below x_low, low
        solve_to far
        append_found roots_found
roots_found:
        store_counts roots_next
roots_end:
        EXIT
        .endkernel
