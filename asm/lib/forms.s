; forms.s - defines operations that are written once and assembled in two
; forms, for numbers in registers and for vectors.
;
; A program first selects a form and then contains operations:
;
;       scalar_form prefix, scratch, second, third
;       vector_form prefix, bits, more_bits, rest
;
; prefix is the start of the name of each operation. It is empty by default, as
; in times and plus. Code for both forms in one program is a macro with an
; argument form. It contains operations such as \form\()_times (asm/lib/exp.s).
; The scalar form changes the registers scratch, second and third. bits has the
; descriptor of the control vector, and more_bits and rest have those of two
; more for and_if, otherwise_if and then_sign.
;
; Both forms execute the same operations in the same order, so their results are
; equal, bit for bit. The vector form links two operations into one stream if
; possible. A control vector replaces the branches of the scalar form.
;
; In the list, k to p are numbers in both forms. Other letters are registers with
; numbers, or with descriptors of vectors of the same length. The operands are in
; the order of the formula, and the result is last. The parts of a name are in the
; order of the operations: lowered_scale lowers a by k and then scales the result
; by l; minus_scaled and from_scaled subtract a product from their first operand.
; A name that ends in _number has a number in place of a vector, and one that ends
; in _index computes with integers. If a meaning begins with *, no operand may be
; indefinite. tests/forms.awk reads this list.
;
; Arithmetic, one operation:
;
;       times a, b, c                   c = a b
;       plus a, b, c                    c = a + b
;       minus a, b, c                   c = a - b
;       quotient a, b, c                c = a / b
;       scale a, k, c                   c = a k
;       raise a, k, c                   c = a + k
;       lower a, k, c                   c = a - k
;       from k, a, c                    c = k - a
;       over a, k, c                    c = a / k
;       into k, a, c                    c = k / a
;       root a, c                       c = sqrt a
;       absolute a, c                   c = |a|
;       negate a, c                     c = -a; a is normalised
;       normal a, c                     c = a, normalised
;       floor a, c                      c = the largest integer not above a, exponent 0
;       truncate a, c                   c = the integer part of a, exponent 0
;       copy a, c                       c = a
;       set k, c                        c = k
;       clear c                         c = 0
;       sign a, k, l, c                 * c = k, or l if a is below 0; c is not a
;       not_above a, c                  * c = the minimum of c and a
;       not_below a, c                  * c = the maximum of c and a
;       not_above_number k, c           * c = the minimum of c and k
;       not_below_number k, c           * c = the maximum of c and k
;
; Arithmetic, several operations:
;
;       line a, k, l, c                 c = a k + l
;       step x, k, c                    c = c x + k, a step of Horner's rule; c is not x
;       step_lower x, k, c              c = c x - k; c is not x
;       scaled_plus a, k, b, c          c = a k + b; a is not b
;       scaled_minus a, k, b, c         c = a k - b; a is not b
;       minus_scaled b, a, k, c         c = b - a k; a is not b
;       from_scaled l, a, k, c          c = l - a k
;       from_product k, a, b, c         c = k - a b
;       raised_scale a, k, l, c         c = (a + k) l
;       raised_times a, k, b, c         c = (a + k) b; c is not b
;       lowered_scale a, k, l, c        c = (a - k) l
;       lowered_times a, k, b, c        c = (a - k) b; c is not b
;       sum_scale a, b, k, c            c = (a + b) k
;       difference_scale a, b, k, c     c = (a - b) k
;       product_double a, b, c          c = 2 a b
;       root_scale a, k, c              c = sqrt(a) k
;       quotient_floor a, b, c
;               c = the largest integer not above a / b, exponent 0
;       over_floor_normal a, k, c
;               c = the largest integer not above a / k, normalised
;       absolute_plus a, b, c           c = |a| + b; c is not b
;       absolute_lower a, k, c          c = |a| - k
;
; Groups. The scalar form interleaves the operations, because a result takes five
; clocks. A result is an operand of a later operation of its group only where the
; list states this:
;
;       line_two a, k, l, c, b, m, n, d
;               c = a k + l, d = b m + n
;       line_three a, k, l, c, b, m, n, d, e, o, p, f
;               also f = e o + p
;       line_four x, y, k, l, m, n, c, d, e, f
;               c = x k + l, d = x m + n, e = y k + l, f = y m + n
;       step_two x, k, c, y, l, d       c = c x + k, d = d y + l
;       step_four x, y, k, l, c, d, e, f
;               c = c x + k, d = d x + l, e = e y + k, f = f y + l
;       derivative_step x, k, c, d      d = d x + c, then c = c x + k
;       scaled_plus_two a, k, b, c, d, l, e, f
;               c = a k + b, then f = d l + e; e may be c
;       scaled_plus_three a, k, b, c, d, l, e, f, g, m, h, i
;               also i = g m + h
;       scaled_plus_scaled_two a, k, b, l, c, d, m, e, n, f
;               c = a k + b l, f = d m + e n
;       scaled_minus_scaled_two a, k, b, l, c, d, m, e, n, f
;               c = a k - b l, f = d m - e n
;       lowered_scale_two a, k, l, c, b, m, n, d
;               c = (a - k) l, d = (b - m) n
;       lowered_scale_three a, k, l, c, b, m, n, d, e, o, p, f
;               also f = (e - o) p
;       lowered_times_three a, k, b, c, d, l, e, f, g, m, h, i
;               c = (a - k) b, f = (d - l) e, i = (g - m) h
;       from_times_two k, a, b, c, l, d, e, f
;               c = (k - a) b, f = (l - d) e
;       absolute_lower_three a, k, c, b, l, d, e, m, f
;               c = |a| - k, d = |b| - l, f = |e| - m
;
; Integers, exponents and tables:
;
;       plus_index a, b, c              c = a + b of integers
;       minus_index a, b, c             c = a - b of integers
;       raise_index a, k, c             c = a + k of integers
;       upper_product a, b, c           c = the upper 47 bits of the product a b
;       low_product a, b, c
;               c = the lower 47 bits; the product of two integers if it is below 2^47
;       low_product_number a, k, c      the same with a number k
;       exponent a, c                   c = the exponent of a, an integer
;       pack_each e, a, c
;               c = the integer e as exponent, the coefficient of a
;       pack_exponent k, a, c
;               c = the integer k as exponent, the coefficient of a
;       pack_coefficient e, k, c
;               c = the integer e as exponent, the coefficient of k
;       gather i, at, c
;               c = word i of the table at the address in the register at
;
; Conditions. A condition begins a case, and end_if with the same label ends it.
; The scalar form branches to the label if the condition is false. The vector form
; computes the operations of the case for all elements. A comparison with an
; indefinite a is false; b and k may not be indefinite. The conditions with * have
; one branch in the scalar form:
;
;       if_above a, b, label            a > b
;       if_above_number a, k, label     a > k
;       if_below_number a, k, label     a < k
;       if_equal_number a, k, label     a = k
;       if_beyond_number a, k, label    |a| > k
;       if_bit a, k, label              the integers a and k have a common bit
;       unless_above_number a, k, label
;               a > k is false
;       unless_below_number a, k, label
;               a < k is false
;       if_less a, b, label             * a < b
;       if_less_number a, k, label      * a < k
;       if_number_less k, a, label      * k < a
;       if_not_less a, b, label         * a >= b
;       if_nearer a, b, label           * |a| < |b|
;       if_not_nearer a, b, label       * |a| >= |b|
;       and_if_not_nearer a, b, label   * the condition is true and |a| >= |b|
;       otherwise_if_not_nearer a, b, label
;               * the condition is false and |a| >= |b|; rest: both are false
;       otherwise_if_less_number a, k, label
;               * the condition is false and a < k
;       otherwise end, label            the condition is false, up to end_if end
;       end_if label                    ends the case
;
; Cases. then_.. stores the elements for which the condition of an if_.. is true.
; otherwise_.. stores those for which the comparison is false, in a case of
; unless_.. or after otherwise:
;
;       then_set k, c                   c = k
;       then_set_minus k, c             c = -k; k is normalised
;       then_clear c                    c = 0
;       then_copy a, c                  c = a
;       then_negate a, c                c = -a
;       then_absolute a, c              c = |a|
;       then_plus a, b, c               c = a + b
;       then_minus a, b, c              c = a - b
;       then_scale a, k, c              c = a k
;       then_raise a, k, c              c = a + k
;       then_lower a, k, c              c = a - k
;       then_from k, a, c               c = k - a
;       then_raise_index a, k, c        c = a + k of integers
;       then_negate_index a, c          c = -a of integers
;       then_sign a, k, l, c, t, case
;               * c = k, or l if a is below 0; changes t; case: rest, or none for bits
;       otherwise_set k, c              c = k
;       otherwise_plus a, b, c          c = a + b
;       default k, c
;               before the condition of then_set_or: c = k, a number or a vector
;       then_set_or k, l, c
;               c = k, or l if the condition is false; default l, c precedes
;       then_set_or_copy k, b, c
;               c = k, or b if the condition is false; default b, c precedes
;
; Leaving early. The scalar form leaves a calculation for a result that the rest
; of it does not change; label is after the last operation of the calculation:
;
;       leaving k, l, c                 begins it: c = k for elements that leave, else l
;       leave_if_number_not_less k, a, m, c, label
;               * c = m if k >= a
;       staying l, c                    ends it

        .ifndef forms.s
        .equ    forms.s, 1

; ---- On numbers --------------------------------------------------------------

        .macro  scalar_form prefix=, scratch=, second=, third=
; Arithmetic, one operation.
        .macro  \prefix\()times a, b, c
        MPYS    \a, \b, \c
        .endm
        .macro  \prefix\()plus a, b, c
        ADDN    \a, \b, \c
        .endm
        .macro  \prefix\()minus a, b, c
        SUBN    \a, \b, \c
        .endm
        .macro  \prefix\()quotient a, b, c
        DIVS    \a, \b, \c
        .endm
        .macro  \prefix\()scale a, k, c
        MPYS    \a, \k, \c
        .endm
        .macro  \prefix\()raise a, k, c
        ADDN    \a, \k, \c
        .endm
        .macro  \prefix\()lower a, k, c
        SUBN    \a, \k, \c
        .endm
        .macro  \prefix\()from k, a, c
        SUBN    \k, \a, \c
        .endm
        .macro  \prefix\()over a, k, c
        DIVS    \a, \k, \c
        .endm
        .macro  \prefix\()into k, a, c
        DIVS    \k, \a, \c
        .endm
        .macro  \prefix\()root a, c
        SQRT    \a, \c
        .endm
        .macro  \prefix\()absolute a, c
        ABS     \a, \c
        .endm
        .macro  \prefix\()negate a, c
        SUBN    r0, \a, \c
        .endm
        .macro  \prefix\()normal a, c
        ADDN    \a, r0, \c
        .endm
        .macro  \prefix\()floor a, c
        FLR     \a, \c
        .endm
        .macro  \prefix\()truncate a, c
        TRU     \a, \c
        .endm
        .macro  \prefix\()copy a, c
        RTOR    \a, \c
        .endm
        .macro  \prefix\()set k, c
        RTOR    \k, \c
        .endm
        .macro  \prefix\()clear c
        ADDN    r0, r0, \c
        .endm
        .macro  \prefix\()sign a, k, l, c
        RTOR    \k, \c
        CFPGE   \a, r0, sign\@
        RTOR    \l, \c
sign\@:
        .endm
        .macro  \prefix\()not_above a, c
        CFPGE   \a, \c, not_above\@
        RTOR    \a, \c
not_above\@:
        .endm
        .macro  \prefix\()not_below a, c
        CFPGE   \c, \a, not_below\@
        RTOR    \a, \c
not_below\@:
        .endm
        .macro  \prefix\()not_above_number k, c
        \prefix\()not_above \k, \c
        .endm
        .macro  \prefix\()not_below_number k, c
        \prefix\()not_below \k, \c
        .endm
; Arithmetic, several operations.
        .macro  \prefix\()line a, k, l, c
        MPYS    \a, \k, \c
        ADDN    \c, \l, \c
        .endm
        .macro  \prefix\()step x, k, c
        MPYS    \c, \x, \c
        ADDN    \c, \k, \c
        .endm
        .macro  \prefix\()step_lower x, k, c
        MPYS    \c, \x, \c
        SUBN    \c, \k, \c
        .endm
        .macro  \prefix\()scaled_plus a, k, b, c
        MPYS    \a, \k, \scratch
        ADDN    \scratch, \b, \c
        .endm
        .macro  \prefix\()scaled_minus a, k, b, c
        MPYS    \a, \k, \scratch
        SUBN    \scratch, \b, \c
        .endm
        .macro  \prefix\()minus_scaled b, a, k, c
        MPYS    \a, \k, \scratch
        SUBN    \b, \scratch, \c
        .endm
        .macro  \prefix\()from_scaled l, a, k, c
        MPYS    \a, \k, \c
        SUBN    \l, \c, \c
        .endm
        .macro  \prefix\()from_product k, a, b, c
        MPYS    \a, \b, \c
        SUBN    \k, \c, \c
        .endm
        .macro  \prefix\()raised_scale a, k, l, c
        ADDN    \a, \k, \c
        MPYS    \c, \l, \c
        .endm
        .macro  \prefix\()raised_times a, k, b, c
        ADDN    \a, \k, \c
        MPYS    \c, \b, \c
        .endm
        .macro  \prefix\()lowered_scale a, k, l, c
        SUBN    \a, \k, \c
        MPYS    \c, \l, \c
        .endm
        .macro  \prefix\()lowered_times a, k, b, c
        SUBN    \a, \k, \c
        MPYS    \c, \b, \c
        .endm
        .macro  \prefix\()sum_scale a, b, k, c
        ADDN    \a, \b, \c
        MPYS    \c, \k, \c
        .endm
        .macro  \prefix\()difference_scale a, b, k, c
        SUBN    \a, \b, \c
        MPYS    \c, \k, \c
        .endm
        .macro  \prefix\()product_double a, b, c
        MPYS    \a, \b, \c
        ADDN    \c, \c, \c
        .endm
        .macro  \prefix\()root_scale a, k, c
        SQRT    \a, \c
        MPYS    \c, \k, \c
        .endm
        .macro  \prefix\()quotient_floor a, b, c
        DIVS    \a, \b, \c
        FLR     \c, \c
        .endm
        .macro  \prefix\()over_floor_normal a, k, c
        DIVS    \a, \k, \c
        FLR     \c, \c
        ADDN    \c, r0, \c
        .endm
        .macro  \prefix\()absolute_plus a, b, c
        ABS     \a, \c
        ADDN    \c, \b, \c
        .endm
        .macro  \prefix\()absolute_lower a, k, c
        ABS     \a, \c
        SUBN    \c, \k, \c
        .endm
; Groups.
        .macro  \prefix\()line_two a, k, l, c, b, m, n, d
        MPYS    \a, \k, \c
        MPYS    \b, \m, \d
        ADDN    \c, \l, \c
        ADDN    \d, \n, \d
        .endm
        .macro  \prefix\()line_three a, k, l, c, b, m, n, d, e, o, p, f
        MPYS    \a, \k, \c
        MPYS    \b, \m, \d
        MPYS    \e, \o, \f
        ADDN    \c, \l, \c
        ADDN    \d, \n, \d
        ADDN    \f, \p, \f
        .endm
        .macro  \prefix\()line_four x, y, k, l, m, n, c, d, e, f
        MPYS    \x, \k, \c
        MPYS    \x, \m, \d
        MPYS    \y, \k, \e
        MPYS    \y, \m, \f
        ADDN    \c, \l, \c
        ADDN    \d, \n, \d
        ADDN    \e, \l, \e
        ADDN    \f, \n, \f
        .endm
        .macro  \prefix\()step_two x, k, c, y, l, d
        MPYS    \c, \x, \c
        MPYS    \d, \y, \d
        ADDN    \c, \k, \c
        ADDN    \d, \l, \d
        .endm
        .macro  \prefix\()step_four x, y, k, l, c, d, e, f
        MPYS    \c, \x, \c
        MPYS    \d, \x, \d
        MPYS    \e, \y, \e
        MPYS    \f, \y, \f
        ADDN    \c, \k, \c
        ADDN    \d, \l, \d
        ADDN    \e, \k, \e
        ADDN    \f, \l, \f
        .endm
        .macro  \prefix\()derivative_step x, k, c, d
        MPYS    \d, \x, \d
        MPYS    \c, \x, \scratch
        ADDN    \c, \d, \d
        ADDN    \scratch, \k, \c
        .endm
        .macro  \prefix\()scaled_plus_two a, k, b, c, d, l, e, f
        MPYS    \a, \k, \scratch
        MPYS    \d, \l, \second
        ADDN    \scratch, \b, \c
        ADDN    \second, \e, \f
        .endm
        .macro  \prefix\()scaled_plus_three a, k, b, c, d, l, e, f, g, m, h, i
        MPYS    \a, \k, \scratch
        MPYS    \d, \l, \second
        MPYS    \g, \m, \third
        ADDN    \scratch, \b, \c
        ADDN    \second, \e, \f
        ADDN    \third, \h, \i
        .endm
        .macro  \prefix\()scaled_plus_scaled_two a, k, b, l, c, d, m, e, n, f
        MPYS    \a, \k, \c
        MPYS    \b, \l, \scratch
        MPYS    \d, \m, \f
        MPYS    \e, \n, \second
        ADDN    \scratch, \c, \c
        ADDN    \second, \f, \f
        .endm
        .macro  \prefix\()scaled_minus_scaled_two a, k, b, l, c, d, m, e, n, f
        MPYS    \a, \k, \c
        MPYS    \b, \l, \scratch
        MPYS    \d, \m, \f
        MPYS    \e, \n, \second
        SUBN    \c, \scratch, \c
        SUBN    \f, \second, \f
        .endm
        .macro  \prefix\()lowered_scale_two a, k, l, c, b, m, n, d
        SUBN    \a, \k, \c
        SUBN    \b, \m, \d
        MPYS    \c, \l, \c
        MPYS    \d, \n, \d
        .endm
        .macro  \prefix\()lowered_scale_three a, k, l, c, b, m, n, d, e, o, p, f
        SUBN    \a, \k, \c
        SUBN    \b, \m, \d
        SUBN    \e, \o, \f
        MPYS    \c, \l, \c
        MPYS    \d, \n, \d
        MPYS    \f, \p, \f
        .endm
        .macro  \prefix\()lowered_times_three a, k, b, c, d, l, e, f, g, m, h, i
        SUBN    \a, \k, \c
        SUBN    \d, \l, \f
        SUBN    \g, \m, \i
        MPYS    \c, \b, \c
        MPYS    \f, \e, \f
        MPYS    \i, \h, \i
        .endm
        .macro  \prefix\()from_times_two k, a, b, c, l, d, e, f
        SUBN    \k, \a, \c
        SUBN    \l, \d, \f
        MPYS    \c, \b, \c
        MPYS    \f, \e, \f
        .endm
        .macro  \prefix\()absolute_lower_three a, k, c, b, l, d, e, m, f
        ABS     \a, \c
        ABS     \b, \d
        ABS     \e, \f
        SUBN    \c, \k, \c
        SUBN    \d, \l, \d
        SUBN    \f, \m, \f
        .endm
; Integers, exponents and tables.
        .macro  \prefix\()plus_index a, b, c
        ADDX    \a, \b, \c
        .endm
        .macro  \prefix\()minus_index a, b, c
        SUBX    \a, \b, \c
        .endm
        .macro  \prefix\()raise_index a, k, c
        ADDX    \a, \k, \c
        .endm
        .macro  \prefix\()upper_product a, b, c
        MPYU    \a, \b, \c
        .endm
        .macro  \prefix\()low_product a, b, c
        MPYL    \a, \b, \c
        .endm
        .macro  \prefix\()low_product_number a, k, c
        MPYL    \a, \k, \c
        .endm
        .macro  \prefix\()exponent a, c
        EXP     \a, \c
        .endm
        .macro  \prefix\()pack_each e, a, c
        PACK    \e, \a, \c
        .endm
        .macro  \prefix\()pack_exponent k, a, c
        PACK    \k, \a, \c
        .endm
        .macro  \prefix\()pack_coefficient e, k, c
        PACK    \e, \k, \c
        .endm
        .macro  \prefix\()gather i, at, c
        LOD     [\at, \i], \c
        .endm
; Conditions.
        .macro  \prefix\()if_above a, b, label
        CFPLE   \a, \b, \label
        CFPNE   \a, \a, \label
        .endm
        .macro  \prefix\()if_above_number a, k, label
        CFPLE   \a, \k, \label
        CFPNE   \a, \a, \label
        .endm
        .macro  \prefix\()if_below_number a, k, label
        CFPGE   \a, \k, \label
        CFPNE   \a, \a, \label
        .endm
        .macro  \prefix\()if_equal_number a, k, label
        CFPNE   \a, \k, \label
        .endm
        .macro  \prefix\()if_beyond_number a, k, label
        ABS     \a, \scratch
        CFPLE   \scratch, \k, \label
        CFPNE   \scratch, \scratch, \label
        .endm
        .macro  \prefix\()if_bit a, k, label
        AND     \a, \k, \scratch
        CFPEQ   \scratch, r0, \label
        .endm
        .macro  \prefix\()unless_above_number a, k, label
        CFPGT   \a, \k, \label
        .endm
        .macro  \prefix\()unless_below_number a, k, label
        CFPLT   \a, \k, \label
        .endm
        .macro  \prefix\()if_less a, b, label
        CFPGE   \a, \b, \label
        .endm
        .macro  \prefix\()if_less_number a, k, label
        CFPGE   \a, \k, \label
        .endm
        .macro  \prefix\()if_number_less k, a, label
        CFPGE   \k, \a, \label
        .endm
        .macro  \prefix\()if_not_less a, b, label
        CFPLT   \a, \b, \label
        .endm
        .macro  \prefix\()if_nearer a, b, label
        ABS     \a, \scratch
        ABS     \b, \second
        CFPGE   \scratch, \second, \label
        .endm
        .macro  \prefix\()if_not_nearer a, b, label
        ABS     \a, \scratch
        ABS     \b, \second
        CFPLT   \scratch, \second, \label
        .endm
        .macro  \prefix\()and_if_not_nearer a, b, label
        \prefix\()if_not_nearer \a, \b, \label
        .endm
        .macro  \prefix\()otherwise_if_not_nearer a, b, label
        \prefix\()if_not_nearer \a, \b, \label
        .endm
        .macro  \prefix\()otherwise_if_less_number a, k, label
        CFPGE   \a, \k, \label
        .endm
        .macro  \prefix\()otherwise end, label
        BIM     \end
\label:
        .endm
        .macro  \prefix\()end_if label
\label:
        .endm
; Cases.
        .macro  \prefix\()then_set k, c
        RTOR    \k, \c
        .endm
        .macro  \prefix\()then_set_minus k, c
        SUBN    r0, \k, \c
        .endm
        .macro  \prefix\()then_clear c
        ADDN    r0, r0, \c
        .endm
        .macro  \prefix\()then_copy a, c
        RTOR    \a, \c
        .endm
        .macro  \prefix\()then_negate a, c
        SUBN    r0, \a, \c
        .endm
        .macro  \prefix\()then_absolute a, c
        ABS     \a, \c
        .endm
        .macro  \prefix\()then_plus a, b, c
        ADDN    \a, \b, \c
        .endm
        .macro  \prefix\()then_minus a, b, c
        SUBN    \a, \b, \c
        .endm
        .macro  \prefix\()then_scale a, k, c
        MPYS    \a, \k, \c
        .endm
        .macro  \prefix\()then_raise a, k, c
        ADDN    \a, \k, \c
        .endm
        .macro  \prefix\()then_lower a, k, c
        SUBN    \a, \k, \c
        .endm
        .macro  \prefix\()then_from k, a, c
        SUBN    \k, \a, \c
        .endm
        .macro  \prefix\()then_raise_index a, k, c
        ADDX    \a, \k, \c
        .endm
        .macro  \prefix\()then_negate_index a, c
        SUBU    r0, \a, \c
        .endm
        .macro  \prefix\()then_sign a, k, l, c, t, case=
        \prefix\()sign \a, \k, \l, \c
        .endm
        .macro  \prefix\()otherwise_set k, c
        RTOR    \k, \c
        .endm
        .macro  \prefix\()otherwise_plus a, b, c
        ADDN    \a, \b, \c
        .endm
        .macro  \prefix\()default k, c
        RTOR    \k, \c
        .endm
        .macro  \prefix\()then_set_or k, l, c
        RTOR    \k, \c
        .endm
        .macro  \prefix\()then_set_or_copy k, b, c
        RTOR    \k, \c
        .endm
; Leaving early.
        .macro  \prefix\()leaving k, l, c
        RTOR    \k, \c
        .endm
        .macro  \prefix\()leave_if_number_not_less k, a, m, c, label
        CFPGE   \k, \a, \label
        .endm
        .macro  \prefix\()staying l, c
        RTOR    \l, \c
        .endm
        .endm

; ---- On vectors --------------------------------------------------------------

; The first operation of a link needs a vector of its length as its result: a
; source or the final result. It does not change this vector.
        .macro  vector_form prefix=, bits=, more_bits=, rest=
; Arithmetic, one operation.
        .macro  \prefix\()times a, b, c
        MPYSV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()plus a, b, c
        ADDNV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()minus a, b, c
        SUBNV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()quotient a, b, c
        DIVSV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()scale a, k, c
        MPYSV   [\a], \k, [\c]
        .endm
        .macro  \prefix\()raise a, k, c
        ADDNV   [\a], \k, [\c]
        .endm
        .macro  \prefix\()lower a, k, c
        SUBNV   [\a], \k, [\c]
        .endm
        .macro  \prefix\()from k, a, c
        SUBNV   \k, [\a], [\c]
        .endm
        .macro  \prefix\()over a, k, c
        DIVSV   [\a], \k, [\c]
        .endm
        .macro  \prefix\()into k, a, c
        DIVSV   \k, [\a], [\c]
        .endm
        .macro  \prefix\()root a, c
        SQRTV   [\a], [\c]
        .endm
        .macro  \prefix\()absolute a, c
        ABSV    [\a], [\c]
        .endm
        .macro  \prefix\()negate a, c
        VTOV    -[\a], [\c]
        .endm
        .macro  \prefix\()normal a, c
        ADDNV   [\a], r0, [\c]
        .endm
        .macro  \prefix\()floor a, c
        FLRV    [\a], [\c]
        .endm
        .macro  \prefix\()truncate a, c
        TRUV    [\a], [\c]
        .endm
        .macro  \prefix\()copy a, c
        VTOV    [\a], [\c]
        .endm
        .macro  \prefix\()set k, c
        VTOV    \k, [\c]
        .endm
        .macro  \prefix\()clear c
        VTOV    r0, [\c]
        .endm
        .macro  \prefix\()sign a, k, l, c
        CMPLTV  [\a], r0, [\bits]
        VTOV    \k, [\c]
        VTOV    \l, [\c] ? [\bits]
        .endm
        .macro  \prefix\()not_above a, c
        CMPLTV  [\a], [\c], [\bits]
        VTOV    [\a], [\c] ? [\bits]
        .endm
        .macro  \prefix\()not_below a, c
        CMPLTV  [\c], [\a], [\bits]
        VTOV    [\a], [\c] ? [\bits]
        .endm
        .macro  \prefix\()not_above_number k, c
        CMPLTV  \k, [\c], [\bits]
        VTOV    \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()not_below_number k, c
        CMPLTV  [\c], \k, [\bits]
        VTOV    \k, [\c] ? [\bits]
        .endm
; Arithmetic, several operations.
        .macro  \prefix\()line a, k, l, c
        LINKV
        MPYSV   [\a], \k, [\c]
        ADDNV   [\c], \l, [\c]
        .endm
        .macro  \prefix\()step x, k, c
        LINKV
        MPYSV   [\c], [\x], [\c]
        ADDNV   [\c], \k, [\c]
        .endm
        .macro  \prefix\()step_lower x, k, c
        LINKV
        MPYSV   [\c], [\x], [\c]
        SUBNV   [\c], \k, [\c]
        .endm
        .macro  \prefix\()scaled_plus a, k, b, c
        LINKV
        MPYSV   [\a], \k, [\a]
        ADDNV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()scaled_minus a, k, b, c
        LINKV
        MPYSV   [\a], \k, [\a]
        SUBNV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()minus_scaled b, a, k, c
        LINKV
        MPYSV   [\a], \k, [\a]
        SUBNV   [\b], [\a], [\c]
        .endm
        .macro  \prefix\()from_scaled l, a, k, c
        LINKV
        MPYSV   [\a], \k, [\c]
        SUBNV   \l, [\c], [\c]
        .endm
        .macro  \prefix\()from_product k, a, b, c
        LINKV
        MPYSV   [\a], [\b], [\c]
        SUBNV   \k, [\c], [\c]
        .endm
        .macro  \prefix\()raised_scale a, k, l, c
        LINKV
        ADDNV   [\a], \k, [\c]
        MPYSV   [\c], \l, [\c]
        .endm
        .macro  \prefix\()raised_times a, k, b, c
        LINKV
        ADDNV   [\a], \k, [\c]
        MPYSV   [\c], [\b], [\c]
        .endm
        .macro  \prefix\()lowered_scale a, k, l, c
        LINKV
        SUBNV   [\a], \k, [\c]
        MPYSV   [\c], \l, [\c]
        .endm
        .macro  \prefix\()lowered_times a, k, b, c
        LINKV
        SUBNV   [\a], \k, [\c]
        MPYSV   [\c], [\b], [\c]
        .endm
        .macro  \prefix\()sum_scale a, b, k, c
        LINKV
        ADDNV   [\a], [\b], [\c]
        MPYSV   [\c], \k, [\c]
        .endm
        .macro  \prefix\()difference_scale a, b, k, c
        LINKV
        SUBNV   [\a], [\b], [\c]
        MPYSV   [\c], \k, [\c]
        .endm
        .macro  \prefix\()product_double a, b, c
        LINKV
        MPYSV   [\a], [\b], [\c]
        ADDNV   [\c], [\c], [\c]
        .endm
        .macro  \prefix\()root_scale a, k, c
        LINKV
        SQRTV   [\a], [\c]
        MPYSV   [\c], \k, [\c]
        .endm
        .macro  \prefix\()quotient_floor a, b, c
        LINKV
        DIVSV   [\a], [\b], [\c]
        FLRV    [\c], [\c]
        .endm
        .macro  \prefix\()over_floor_normal a, k, c
        LINKV
        DIVSV   [\a], \k, [\c]
        FLRV    [\c], [\c]
        ADDNV   [\c], r0, [\c]
        .endm
        .macro  \prefix\()absolute_plus a, b, c
        ADDNV   |[\a]|, [\b], [\c]
        .endm
        .macro  \prefix\()absolute_lower a, k, c
        SUBNV   |[\a]|, \k, [\c]
        .endm
; Groups.
        .macro  \prefix\()line_two a, k, l, c, b, m, n, d
        \prefix\()line \a, \k, \l, \c
        \prefix\()line \b, \m, \n, \d
        .endm
        .macro  \prefix\()line_three a, k, l, c, b, m, n, d, e, o, p, f
        \prefix\()line_two \a, \k, \l, \c, \b, \m, \n, \d
        \prefix\()line \e, \o, \p, \f
        .endm
        .macro  \prefix\()line_four x, y, k, l, m, n, c, d, e, f
        \prefix\()line_two \x, \k, \l, \c, \x, \m, \n, \d
        \prefix\()line_two \y, \k, \l, \e, \y, \m, \n, \f
        .endm
        .macro  \prefix\()step_two x, k, c, y, l, d
        \prefix\()step \x, \k, \c
        \prefix\()step \y, \l, \d
        .endm
        .macro  \prefix\()step_four x, y, k, l, c, d, e, f
        \prefix\()step_two \x, \k, \c, \x, \l, \d
        \prefix\()step_two \y, \k, \e, \y, \l, \f
        .endm
        .macro  \prefix\()derivative_step x, k, c, d
        MPYSV   [\d], [\x], [\d]
        ADDNV   [\c], [\d], [\d]
        \prefix\()step \x, \k, \c
        .endm
        .macro  \prefix\()scaled_plus_two a, k, b, c, d, l, e, f
        \prefix\()scaled_plus \a, \k, \b, \c
        \prefix\()scaled_plus \d, \l, \e, \f
        .endm
        .macro  \prefix\()scaled_plus_three a, k, b, c, d, l, e, f, g, m, h, i
        \prefix\()scaled_plus_two \a, \k, \b, \c, \d, \l, \e, \f
        \prefix\()scaled_plus \g, \m, \h, \i
        .endm
        .macro  \prefix\()scaled_plus_scaled_two a, k, b, l, c, d, m, e, n, f
        \prefix\()scale \a, \k, \c
        \prefix\()scaled_plus \b, \l, \c, \c
        \prefix\()scale \d, \m, \f
        \prefix\()scaled_plus \e, \n, \f, \f
        .endm
        .macro  \prefix\()scaled_minus_scaled_two a, k, b, l, c, d, m, e, n, f
        \prefix\()scale \a, \k, \c
        \prefix\()minus_scaled \c, \b, \l, \c
        \prefix\()scale \d, \m, \f
        \prefix\()minus_scaled \f, \e, \n, \f
        .endm
        .macro  \prefix\()lowered_scale_two a, k, l, c, b, m, n, d
        \prefix\()lowered_scale \a, \k, \l, \c
        \prefix\()lowered_scale \b, \m, \n, \d
        .endm
        .macro  \prefix\()lowered_scale_three a, k, l, c, b, m, n, d, e, o, p, f
        \prefix\()lowered_scale_two \a, \k, \l, \c, \b, \m, \n, \d
        \prefix\()lowered_scale \e, \o, \p, \f
        .endm
        .macro  \prefix\()lowered_times_three a, k, b, c, d, l, e, f, g, m, h, i
        \prefix\()lowered_times \a, \k, \b, \c
        \prefix\()lowered_times \d, \l, \e, \f
        \prefix\()lowered_times \g, \m, \h, \i
        .endm
        .macro  \prefix\()from_times_two k, a, b, c, l, d, e, f
        LINKV
        SUBNV   \k, [\a], [\c]
        MPYSV   [\c], [\b], [\c]
        LINKV
        SUBNV   \l, [\d], [\f]
        MPYSV   [\f], [\e], [\f]
        .endm
        .macro  \prefix\()absolute_lower_three a, k, c, b, l, d, e, m, f
        \prefix\()absolute_lower \a, \k, \c
        \prefix\()absolute_lower \b, \l, \d
        \prefix\()absolute_lower \e, \m, \f
        .endm
; Integers, exponents and tables.
        .macro  \prefix\()plus_index a, b, c
        ADDXV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()minus_index a, b, c
        SUBXV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()raise_index a, k, c
        ADDXV   [\a], \k, [\c]
        .endm
        .macro  \prefix\()upper_product a, b, c
        MPYUV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()low_product a, b, c
        MPYLV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()low_product_number a, k, c
        MPYLV   [\a], \k, [\c]
        .endm
        .macro  \prefix\()exponent a, c
        EXPV    [\a], [\c]
        .endm
        .macro  \prefix\()pack_each e, a, c
        PACKV   [\e], [\a], [\c]
        .endm
        .macro  \prefix\()pack_exponent k, a, c
        PACKV   \k, [\a], [\c]
        .endm
        .macro  \prefix\()pack_coefficient e, k, c
        PACKV   [\e], \k, [\c]
        .endm
        .macro  \prefix\()gather i, at, c
        VXTOV   [\i], [\at], [\c]
        .endm
; Conditions.
        .macro  \prefix\()if_above a, b, label
        CMPLTV  [\b], [\a], [\bits]
        .endm
        .macro  \prefix\()if_above_number a, k, label
        CMPLTV  \k, [\a], [\bits]
        .endm
        .macro  \prefix\()if_below_number a, k, label
        CMPLTV  [\a], \k, [\bits]
        .endm
        .macro  \prefix\()if_equal_number a, k, label
        CMPEQV  [\a], \k, [\bits]
        .endm
        .macro  \prefix\()if_beyond_number a, k, label
        CMPLTV  \k, |[\a]|, [\bits]
        .endm
        .macro  \prefix\()if_bit a, k, label
        LINKV
        ANDV    [\a], \k, [\a]
        CMPNEV  [\a], r0, [\bits]
        .endm
        .macro  \prefix\()unless_above_number a, k, label
        CMPLTV  \k, [\a], [\bits]
        .endm
        .macro  \prefix\()unless_below_number a, k, label
        CMPLTV  [\a], \k, [\bits]
        .endm
        .macro  \prefix\()if_less a, b, label
        CMPLTV  [\a], [\b], [\bits]
        .endm
        .macro  \prefix\()if_less_number a, k, label
        CMPLTV  [\a], \k, [\bits]
        .endm
        .macro  \prefix\()if_number_less k, a, label
        CMPLTV  \k, [\a], [\bits]
        .endm
        .macro  \prefix\()if_not_less a, b, label
        CMPGEV  [\a], [\b], [\bits]
        .endm
        .macro  \prefix\()if_nearer a, b, label
        CMPLTV  |[\a]|, |[\b]|, [\bits]
        .endm
        .macro  \prefix\()if_not_nearer a, b, label
        CMPGEV  |[\a]|, |[\b]|, [\bits]
        .endm
        .macro  \prefix\()and_if_not_nearer a, b, label
        CMPGEV  |[\a]|, |[\b]|, [\more_bits]
        ANDB    [\bits], [\more_bits], [\bits]
        .endm
        .macro  \prefix\()otherwise_if_not_nearer a, b, label
        CMPGEV  |[\a]|, |[\b]|, [\more_bits]
        NORB    [\bits], [\more_bits], [\rest]
        ANDNB   [\more_bits], [\bits], [\bits]
        .endm
        .macro  \prefix\()otherwise_if_less_number a, k, label
        CMPLTV  [\a], \k, [\more_bits]
        ANDNB   [\more_bits], [\bits], [\bits]
        .endm
        .macro  \prefix\()otherwise end, label
        .endm
        .macro  \prefix\()end_if label
        .endm
; Cases.
        .macro  \prefix\()then_set k, c
        VTOV    \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_set_minus k, c
        VTOV    -\k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_clear c
        VTOV    r0, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_copy a, c
        VTOV    [\a], [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_negate a, c
        SUBNV   r0, [\a], [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_absolute a, c
        ABSV    [\a], [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_plus a, b, c
        ADDNV   [\a], [\b], [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_minus a, b, c
        SUBNV   [\a], [\b], [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_scale a, k, c
        MPYSV   [\a], \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_raise a, k, c
        ADDNV   [\a], \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_lower a, k, c
        SUBNV   [\a], \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_from k, a, c
        SUBNV   \k, [\a], [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_raise_index a, k, c
        ADDXV   [\a], \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_negate_index a, c
        SUBUV   r0, [\a], [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_sign a, k, l, c, t, case=\bits
        CMPGEV  [\a], r0, [\more_bits]
        MASKV   \k, \l, [\t] ? [\more_bits]
        VTOV    [\t], [\c] ? [\case]
        .endm
        .macro  \prefix\()otherwise_set k, c
        VTOV    \k, [\c] ?! [\bits]
        .endm
        .macro  \prefix\()otherwise_plus a, b, c
        ADDNV   [\a], [\b], [\c] ?! [\bits]
        .endm
        .macro  \prefix\()default k, c
        .endm
        .macro  \prefix\()then_set_or k, l, c
        MASKV   \k, \l, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_set_or_copy k, b, c
        MASKV   \k, [\b], [\c] ? [\bits]
        .endm
; Leaving early.
        .macro  \prefix\()leaving k, l, c
        VTOV    \l, [\c]
        .endm
        .macro  \prefix\()leave_if_number_not_less k, a, m, c, label
        CMPGEV  \k, [\a], [\bits]
        VTOV    \m, [\c] ? [\bits]
        .endm
        .macro  \prefix\()staying l, c
        .endm
        .endm

        .endif
