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
; more for and_if and otherwise_if.
;
; Both forms execute the same operations in the same order, so their results are
; equal, bit for bit. The vector form links two operations into one stream if
; possible. A control vector replaces the branches of the scalar form.
;
; In the list, a, b, c are registers with numbers, or with descriptors of
; vectors of the same length. k and l are numbers in both forms.
;
;       times a, b, c           c = a b           plus a, b, c        c = a + b
;       minus a, b, c           c = a - b         quotient a, b, c    c = a / b
;       scale a, k, c           c = a k           raise a, k, c       c = a + k
;       lower a, k, c           c = a - k         from k, a, c        c = k - a
;       into k, a, c            c = k / a         over a, k, c        c = a / k
;       root a, c               c = sqrt a
;       absolute a, c           c = |a|           copy a, c           c = a
;       set k, c                c = k             clear c             c = 0
;       negate a, c             c = -a
;       normal a, c             c = a, normalised
;       floor a, c              c = the largest integer not above a, exponent 0
;       truncate a, c           c = the integer part of a, exponent 0
;       sign a, k, l, c         c = k, or l if a is below 0
;       not_above a, c          c = the lesser of c and a     none is indefinite
;       not_below a, c          c = the greater of c and a    none is indefinite
;       not_above_number k, c   c = the lesser of c and k     none is indefinite
;       not_below_number k, c   c = the greater of c and k    none is indefinite
;
;       line a, k, l, c         c = a k + l
;       step x, k, c            c = c x + k, a step of Horner's rule
;       step_lower x, k, c      c = c x - k
;       scaled_plus a, k, b, c  c = b + a k       a is not b
;       minus_scaled a, k, b, c c = b - a k       a is not b
;       scaled_less a, k, b, c  c = a k - b       a is not b
;       from_scaled a, k, l, c  c = l - a k
;       scaled_root a, k, c     c = k sqrt a
;       twice_times a, b, c     c = 2 a b
;       scaled_lower a, k, l, c c = (a - k) l
;       scaled_difference a, b, k, c  c = (a - b) k
;       scaled_sum a, b, k, c         c = (a + b) k
;       scaled_raise a, k, l, c   c = (a + k) l
;       from_product k, a, b, c   c = k - a b
;       lower_absolute a, k, c  c = |a| - k
;       plus_absolute a, b, c   c = |a| + b       c is not b
;       floor_over a, k, c      c = the largest integer not above a / k
;       floor_quotient a, b, c  c = the largest integer not above a / b, exponent 0
;       raised_times a, k, b, c c = (a + k) b
;       lowered_times a, k, b, c c = (a - k) b
;
; Several operations. The scalar form interleaves them, because a result takes
; five clocks:
;
;       line_two a, k, l, c, m, n, d            c = a k + l,  d = a m + n
;       line_three a, k, l, c, m, n, d, o, p, e  also e = a o + p
;       step_both x, p, y, q, k               p = p x + k,  q = q y + k
;       line_four x, k, l, p, m, n, q, y, r, s
;               p = x k + l,  q = x m + n,  r = y k + l,  s = y m + n
;       step_four x, p, k, q, l, y, r, s
;               p = p x + k,  q = q x + l,  r = r y + k,  s = s y + l
;       derivative_step x, k, v, d            d = d x + v, then v = v x + k
;       scaled_sum_two x, y, k, l, s, m, n, t  s = x k + y l,  t = x m + y n
;       scaled_lower_two a, k, m, s, b, l, n, t  s = (a - k) m,  t = (b - l) n
;       scaled_plus_two a, k, b, c, d, l, e, f  c = a k + b,  f = d l + e
;       scaled_plus_three a, k, b, c, d, l, e, f, g, m, h, i  also i = g m + h
;       from_times_two k, l, a, b, c, d  c = (k - a) b,  d = (l - a) b
;       scaled_difference_two x, y, k, l, s, m, n, t  s = x k - y l,  t = x m - y n
;       lower_absolute_three a, k, s, b, l, t, c, m, u
;               s = |a| - k, likewise t = |b| - l and u = |c| - m
;       scaled_lower_three a, k, s, b, l, t, c, m, u, n
;               s = (a - k) n, likewise t = (b - l) n and u = (c - m) n
;       lower_times_three a, k, s, b, l, t, c, m, u, x        the same with x
;
; Integers, exponents and tables:
;
;       exponent a, c           c = the exponent of a, an integer
;       add_index a, b, c       c = a + b of integers
;       raise_index a, k, c     c = a + k of integers
;       minus_index a, b, c     c = a - b of integers
;       upper_product a, b, c   c = the first 47 digits of a b
;       low_product a, b, c     c = the other digits of a b; the whole product
;                               of integers if it is below 2^47
;       low_scale a, k, c       the same with a number k
;       pick i, at, c           c = word i of a table; at: register with its
;                               address
;       pack_each e, a, c        c = the exponent e with the coefficient of a
;       pack_all k, a, c        like pack_each, with the exponent k for all
;       pack_number e, k, c     like pack_each, with the coefficient of k for all
;
; Conditions: vectors compute all operations between the condition and end_if
; label for all elements. Operations then_.. store only elements for which the
; condition is true. A condition on an indefinite a is false.
;
;       if_above a, b, label            is a > b?
;       if_above_number a, k, label     is a > k?
;       if_below_number a, k, label     is a < k?
;       if_equal_number a, k, label     is a = k?
;       if_beyond_number a, k, label    is |a| > k?
;       if_bit a, k, label              has the integer a the bit of k?
;       unless_above_number a, k, label is a > k false?
;       unless_less_number a, k, label  is a < k false?
;       otherwise end, label            from here to end_if end: elements for
;                                       which the condition is false
;       then_set k, c      then_copy a, c            then_plus a, b, c
;       then_from k, a, c  then_raise a, k, c        then_raise_index a, k, c
;       then_negate a, c   then_negate_index a, c    then_clear c
;       then_scale a, k, c then_lower a, k, c        then_set_minus k, c
;       then_sign a, k, l, c, t, case   c = k, or l if a is below 0; changes t
;       otherwise_set k, c       if the condition is false
;       then_absolute a, c       then_minus a, b, c
;       otherwise_plus a, b, c   if the condition is false
;       default k, c             before the condition: k is a number or a vector
;       then_set_or k, l, c      c = k, or l where the condition is false; l is
;                                the operand of default
;       then_set_or_copy k, b, c the same with the default b
;
; Conditions with one branch in the scalar form; no operand may be indefinite:
;
;       if_less a, b, label             is a < b?
;       if_less_number a, k, label      is a < k?
;       if_number_less k, a, label      is k < a?
;       if_not_less a, b, label         is a >= b?
;       if_nearer a, b, label           is |a| < |b|?
;       if_not_nearer a, b, label       is |a| >= |b|?
;       and_if_not_nearer a, b, label           is it true and |a| >= |b|?
;       otherwise_if_less_number a, k, label    is it false and a < k?
;       otherwise_if_not_nearer a, b, label     is it false and |a| >= |b|?
;                               the case rest of then_sign: if both are false
;
; The scalar form leaves a calculation early, for a result that the rest does
; not change; label is after the last one of these:
;
;       leaving k, l, c                 c = k for elements that leave, else l
;       leave_if_number_not_less k, a, m, c, label   if k >= a, with c = m
;       staying l, c                    ends it

        .ifndef forms.s
        .equ    forms.s, 1

; ---- On numbers --------------------------------------------------------------

        .macro  scalar_form prefix=, scratch=, second=, third=
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
        .macro  \prefix\()into k, a, c
        DIVS    \k, \a, \c
        .endm
        .macro  \prefix\()over a, k, c
        DIVS    \a, \k, \c
        .endm
        .macro  \prefix\()root a, c
        SQRT    \a, \c
        .endm
        .macro  \prefix\()absolute a, c
        ABS     \a, \c
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
        .macro  \prefix\()minus_scaled a, k, b, c
        MPYS    \a, \k, \scratch
        SUBN    \b, \scratch, \c
        .endm
        .macro  \prefix\()scaled_less a, k, b, c
        MPYS    \a, \k, \scratch
        SUBN    \scratch, \b, \c
        .endm
        .macro  \prefix\()from_scaled a, k, l, c
        MPYS    \a, \k, \c
        SUBN    \l, \c, \c
        .endm
        .macro  \prefix\()scaled_root a, k, c
        SQRT    \a, \c
        MPYS    \c, \k, \c
        .endm
        .macro  \prefix\()twice_times a, b, c
        MPYS    \a, \b, \c
        ADDN    \c, \c, \c
        .endm
        .macro  \prefix\()scaled_lower a, k, l, c
        SUBN    \a, \k, \c
        MPYS    \c, \l, \c
        .endm
        .macro  \prefix\()scaled_difference a, b, k, c
        SUBN    \a, \b, \c
        MPYS    \c, \k, \c
        .endm
        .macro  \prefix\()floor_over a, k, c
        DIVS    \a, \k, \c
        FLR     \c, \c
        ADDN    \c, r0, \c
        .endm
        .macro  \prefix\()floor_quotient a, b, c
        DIVS    \a, \b, \c
        FLR     \c, \c
        .endm
        .macro  \prefix\()scaled_sum a, b, k, c
        ADDN    \a, \b, \c
        MPYS    \c, \k, \c
        .endm
        .macro  \prefix\()scaled_raise a, k, l, c
        ADDN    \a, \k, \c
        MPYS    \c, \l, \c
        .endm
        .macro  \prefix\()from_product k, a, b, c
        MPYS    \a, \b, \c
        SUBN    \k, \c, \c
        .endm
        .macro  \prefix\()lower_absolute a, k, c
        ABS     \a, \c
        SUBN    \c, \k, \c
        .endm
        .macro  \prefix\()plus_absolute a, b, c
        ABS     \a, \c
        ADDN    \c, \b, \c
        .endm
        .macro  \prefix\()line_two a, k, l, c, m, n, d
        MPYS    \a, \k, \c
        MPYS    \a, \m, \d
        ADDN    \c, \l, \c
        ADDN    \d, \n, \d
        .endm
        .macro  \prefix\()line_three a, k, l, c, m, n, d, o, p, e
        MPYS    \a, \k, \c
        MPYS    \a, \m, \d
        MPYS    \a, \o, \e
        ADDN    \c, \l, \c
        ADDN    \d, \n, \d
        ADDN    \e, \p, \e
        .endm
        .macro  \prefix\()raised_times a, k, b, c
        ADDN    \a, \k, \c
        MPYS    \c, \b, \c
        .endm
        .macro  \prefix\()lowered_times a, k, b, c
        SUBN    \a, \k, \c
        MPYS    \c, \b, \c
        .endm
        .macro  \prefix\()scaled_plus_three a, k, b, c, d, l, e, f, g, m, h, i
        MPYS    \a, \k, \scratch
        MPYS    \d, \l, \second
        MPYS    \g, \m, \third
        ADDN    \scratch, \b, \c
        ADDN    \second, \e, \f
        ADDN    \third, \h, \i
        .endm
        .macro  \prefix\()line_four x, k, l, p, m, n, q, y, r, s
        MPYS    \x, \k, \p
        MPYS    \x, \m, \q
        MPYS    \y, \k, \r
        MPYS    \y, \m, \s
        ADDN    \p, \l, \p
        ADDN    \q, \n, \q
        ADDN    \r, \l, \r
        ADDN    \s, \n, \s
        .endm
        .macro  \prefix\()step_four x, p, k, q, l, y, r, s
        MPYS    \p, \x, \p
        MPYS    \q, \x, \q
        MPYS    \r, \y, \r
        MPYS    \s, \y, \s
        ADDN    \p, \k, \p
        ADDN    \q, \l, \q
        ADDN    \r, \k, \r
        ADDN    \s, \l, \s
        .endm
        .macro  \prefix\()step_both x, p, y, q, k
        MPYS    \p, \x, \p
        MPYS    \q, \y, \q
        ADDN    \p, \k, \p
        ADDN    \q, \k, \q
        .endm
        .macro  \prefix\()derivative_step x, k, v, d
        MPYS    \d, \x, \d
        MPYS    \v, \x, \scratch
        ADDN    \v, \d, \d
        ADDN    \scratch, \k, \v
        .endm
        .macro  \prefix\()scaled_sum_two x, y, k, l, s, m, n, t
        MPYS    \x, \k, \s
        MPYS    \y, \l, \scratch
        MPYS    \x, \m, \t
        MPYS    \y, \n, \second
        ADDN    \scratch, \s, \s
        ADDN    \second, \t, \t
        .endm
        .macro  \prefix\()scaled_lower_two a, k, m, s, b, l, n, t
        SUBN    \a, \k, \s
        SUBN    \b, \l, \t
        MPYS    \s, \m, \s
        MPYS    \t, \n, \t
        .endm
        .macro  \prefix\()scaled_plus_two a, k, b, c, d, l, e, f
        MPYS    \a, \k, \scratch
        MPYS    \d, \l, \second
        ADDN    \scratch, \b, \c
        ADDN    \second, \e, \f
        .endm
        .macro  \prefix\()from_times_two k, l, a, b, c, d
        SUBN    \k, \a, \c
        SUBN    \l, \a, \d
        MPYS    \c, \b, \c
        MPYS    \d, \b, \d
        .endm
        .macro  \prefix\()scaled_difference_two x, y, k, l, s, m, n, t
        MPYS    \x, \k, \s
        MPYS    \y, \l, \scratch
        MPYS    \x, \m, \t
        MPYS    \y, \n, \second
        SUBN    \s, \scratch, \s
        SUBN    \t, \second, \t
        .endm
        .macro  \prefix\()lower_absolute_three a, k, s, b, l, t, c, m, u
        ABS     \a, \s
        ABS     \b, \t
        ABS     \c, \u
        SUBN    \s, \k, \s
        SUBN    \t, \l, \t
        SUBN    \u, \m, \u
        .endm
        .macro  \prefix\()scaled_lower_three a, k, s, b, l, t, c, m, u, n
        SUBN    \a, \k, \s
        SUBN    \b, \l, \t
        SUBN    \c, \m, \u
        MPYS    \s, \n, \s
        MPYS    \t, \n, \t
        MPYS    \u, \n, \u
        .endm
        .macro  \prefix\()lower_times_three a, k, s, b, l, t, c, m, u, x
        \prefix\()scaled_lower_three \a, \k, \s, \b, \l, \t, \c, \m, \u, \x
        .endm
        .macro  \prefix\()exponent a, c
        EXP     \a, \c
        .endm
        .macro  \prefix\()add_index a, b, c
        ADDX    \a, \b, \c
        .endm
        .macro  \prefix\()raise_index a, k, c
        ADDX    \a, \k, \c
        .endm
        .macro  \prefix\()minus_index a, b, c
        SUBX    \a, \b, \c
        .endm
        .macro  \prefix\()upper_product a, b, c
        MPYU    \a, \b, \c
        .endm
        .macro  \prefix\()low_product a, b, c
        MPYL    \a, \b, \c
        .endm
        .macro  \prefix\()low_scale a, k, c
        MPYL    \a, \k, \c
        .endm
        .macro  \prefix\()pick i, at, c
        LOD     [\at, \i], \c
        .endm
        .macro  \prefix\()pack_each e, a, c
        PACK    \e, \a, \c
        .endm
        .macro  \prefix\()pack_all k, a, c
        PACK    \k, \a, \c
        .endm
        .macro  \prefix\()pack_number e, k, c
        PACK    \e, \k, \c
        .endm
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
        .macro  \prefix\()unless_less_number a, k, label
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
        .macro  \prefix\()leaving k, l, c
        RTOR    \k, \c
        .endm
        .macro  \prefix\()leave_if_number_not_less k, a, m, c, label
        CFPGE   \k, \a, \label
        .endm
        .macro  \prefix\()staying l, c
        RTOR    \l, \c
        .endm
        .macro  \prefix\()otherwise end, label
        BIM     \end
\label:
        .endm
        .macro  \prefix\()end_if label
\label:
        .endm
        .macro  \prefix\()then_set k, c
        RTOR    \k, \c
        .endm
        .macro  \prefix\()then_clear c
        ADDN    r0, r0, \c
        .endm
        .macro  \prefix\()then_copy a, c
        RTOR    \a, \c
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
        .macro  \prefix\()then_raise a, k, c
        ADDN    \a, \k, \c
        .endm
        .macro  \prefix\()then_from k, a, c
        SUBN    \k, \a, \c
        .endm
        .macro  \prefix\()then_raise_index a, k, c
        ADDX    \a, \k, \c
        .endm
        .macro  \prefix\()then_negate a, c
        SUBN    r0, \a, \c
        .endm
        .macro  \prefix\()then_scale a, k, c
        MPYS    \a, \k, \c
        .endm
        .macro  \prefix\()then_lower a, k, c
        SUBN    \a, \k, \c
        .endm
        .macro  \prefix\()then_set_minus k, c
        SUBN    r0, \k, \c
        .endm
        .macro  \prefix\()then_negate_index a, c
        SUBU    r0, \a, \c
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
        .macro  \prefix\()then_sign a, k, l, c, t, case=
        \prefix\()sign \a, \k, \l, \c
        .endm
        .macro  \prefix\()otherwise_set k, c
        RTOR    \k, \c
        .endm
        .macro  \prefix\()otherwise_plus a, b, c
        ADDN    \a, \b, \c
        .endm
        .endm

; ---- On vectors --------------------------------------------------------------

; The first operation of a link needs a vector of its length as its result: a
; source or the final result. It does not change this vector.
        .macro  vector_form prefix=, bits=, more_bits=, rest=
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
        .macro  \prefix\()into k, a, c
        DIVSV   \k, [\a], [\c]
        .endm
        .macro  \prefix\()over a, k, c
        DIVSV   [\a], \k, [\c]
        .endm
        .macro  \prefix\()root a, c
        SQRTV   [\a], [\c]
        .endm
        .macro  \prefix\()absolute a, c
        ABSV    [\a], [\c]
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
        .macro  \prefix\()minus_scaled a, k, b, c
        LINKV
        MPYSV   [\a], \k, [\a]
        SUBNV   [\b], [\a], [\c]
        .endm
        .macro  \prefix\()scaled_less a, k, b, c
        LINKV
        MPYSV   [\a], \k, [\a]
        SUBNV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()from_scaled a, k, l, c
        LINKV
        MPYSV   [\a], \k, [\c]
        SUBNV   \l, [\c], [\c]
        .endm
        .macro  \prefix\()scaled_root a, k, c
        LINKV
        SQRTV   [\a], [\c]
        MPYSV   [\c], \k, [\c]
        .endm
        .macro  \prefix\()twice_times a, b, c
        LINKV
        MPYSV   [\a], [\b], [\c]
        ADDNV   [\c], [\c], [\c]
        .endm
        .macro  \prefix\()scaled_lower a, k, l, c
        LINKV
        SUBNV   [\a], \k, [\c]
        MPYSV   [\c], \l, [\c]
        .endm
        .macro  \prefix\()scaled_difference a, b, k, c
        LINKV
        SUBNV   [\a], [\b], [\c]
        MPYSV   [\c], \k, [\c]
        .endm
        .macro  \prefix\()floor_over a, k, c
        LINKV
        DIVSV   [\a], \k, [\c]
        FLRV    [\c], [\c]
        ADDNV   [\c], r0, [\c]
        .endm
        .macro  \prefix\()floor_quotient a, b, c
        LINKV
        DIVSV   [\a], [\b], [\c]
        FLRV    [\c], [\c]
        .endm
        .macro  \prefix\()scaled_sum a, b, k, c
        LINKV
        ADDNV   [\a], [\b], [\c]
        MPYSV   [\c], \k, [\c]
        .endm
        .macro  \prefix\()scaled_raise a, k, l, c
        LINKV
        ADDNV   [\a], \k, [\c]
        MPYSV   [\c], \l, [\c]
        .endm
        .macro  \prefix\()from_product k, a, b, c
        LINKV
        MPYSV   [\a], [\b], [\c]
        SUBNV   \k, [\c], [\c]
        .endm
        .macro  \prefix\()lower_absolute a, k, c
        SUBNV   |[\a]|, \k, [\c]
        .endm
        .macro  \prefix\()plus_absolute a, b, c
        ADDNV   |[\a]|, [\b], [\c]
        .endm
        .macro  \prefix\()line_two a, k, l, c, m, n, d
        \prefix\()line \a, \k, \l, \c
        \prefix\()line \a, \m, \n, \d
        .endm
        .macro  \prefix\()line_three a, k, l, c, m, n, d, o, p, e
        \prefix\()line_two \a, \k, \l, \c, \m, \n, \d
        \prefix\()line \a, \o, \p, \e
        .endm
        .macro  \prefix\()raised_times a, k, b, c
        LINKV
        ADDNV   [\a], \k, [\c]
        MPYSV   [\c], [\b], [\c]
        .endm
        .macro  \prefix\()lowered_times a, k, b, c
        LINKV
        SUBNV   [\a], \k, [\c]
        MPYSV   [\c], [\b], [\c]
        .endm
        .macro  \prefix\()scaled_plus_three a, k, b, c, d, l, e, f, g, m, h, i
        \prefix\()scaled_plus_two \a, \k, \b, \c, \d, \l, \e, \f
        \prefix\()scaled_plus \g, \m, \h, \i
        .endm
        .macro  \prefix\()line_four x, k, l, p, m, n, q, y, r, s
        \prefix\()line \x, \k, \l, \p
        \prefix\()line \x, \m, \n, \q
        \prefix\()line \y, \k, \l, \r
        \prefix\()line \y, \m, \n, \s
        .endm
        .macro  \prefix\()step_four x, p, k, q, l, y, r, s
        \prefix\()step \x, \k, \p
        \prefix\()step \x, \l, \q
        \prefix\()step \y, \k, \r
        \prefix\()step \y, \l, \s
        .endm
        .macro  \prefix\()step_both x, p, y, q, k
        \prefix\()step \x, \k, \p
        \prefix\()step \y, \k, \q
        .endm
        .macro  \prefix\()derivative_step x, k, v, d
        MPYSV   [\d], [\x], [\d]
        ADDNV   [\v], [\d], [\d]
        \prefix\()step \x, \k, \v
        .endm
        .macro  \prefix\()scaled_sum_two x, y, k, l, s, m, n, t
        \prefix\()scale \x, \k, \s
        \prefix\()scaled_plus \y, \l, \s, \s
        \prefix\()scale \x, \m, \t
        \prefix\()scaled_plus \y, \n, \t, \t
        .endm
        .macro  \prefix\()scaled_lower_two a, k, m, s, b, l, n, t
        \prefix\()scaled_lower \a, \k, \m, \s
        \prefix\()scaled_lower \b, \l, \n, \t
        .endm
        .macro  \prefix\()scaled_plus_two a, k, b, c, d, l, e, f
        \prefix\()scaled_plus \a, \k, \b, \c
        \prefix\()scaled_plus \d, \l, \e, \f
        .endm
        .macro  \prefix\()from_times_two k, l, a, b, c, d
        LINKV
        SUBNV   \k, [\a], [\c]
        MPYSV   [\c], [\b], [\c]
        LINKV
        SUBNV   \l, [\a], [\d]
        MPYSV   [\d], [\b], [\d]
        .endm
        .macro  \prefix\()scaled_difference_two x, y, k, l, s, m, n, t
        \prefix\()scale \x, \k, \s
        \prefix\()minus_scaled \y, \l, \s, \s
        \prefix\()scale \x, \m, \t
        \prefix\()minus_scaled \y, \n, \t, \t
        .endm
        .macro  \prefix\()lower_absolute_three a, k, s, b, l, t, c, m, u
        SUBNV   |[\a]|, \k, [\s]
        SUBNV   |[\b]|, \l, [\t]
        SUBNV   |[\c]|, \m, [\u]
        .endm
        .macro  \prefix\()scaled_lower_three a, k, s, b, l, t, c, m, u, n
        \prefix\()scaled_lower \a, \k, \n, \s
        \prefix\()scaled_lower \b, \l, \n, \t
        \prefix\()scaled_lower \c, \m, \n, \u
        .endm
        .macro  \prefix\()lower_times_three a, k, s, b, l, t, c, m, u, x
        LINKV
        SUBNV   [\a], \k, [\s]
        MPYSV   [\s], [\x], [\s]
        LINKV
        SUBNV   [\b], \l, [\t]
        MPYSV   [\t], [\x], [\t]
        LINKV
        SUBNV   [\c], \m, [\u]
        MPYSV   [\u], [\x], [\u]
        .endm
        .macro  \prefix\()exponent a, c
        EXPV    [\a], [\c]
        .endm
        .macro  \prefix\()add_index a, b, c
        ADDXV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()raise_index a, k, c
        ADDXV   [\a], \k, [\c]
        .endm
        .macro  \prefix\()minus_index a, b, c
        SUBXV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()upper_product a, b, c
        MPYUV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()low_product a, b, c
        MPYLV   [\a], [\b], [\c]
        .endm
        .macro  \prefix\()low_scale a, k, c
        MPYLV   [\a], \k, [\c]
        .endm
        .macro  \prefix\()pick i, at, c
        VXTOV   [\i], [\at], [\c]
        .endm
        .macro  \prefix\()pack_each e, a, c
        PACKV   [\e], [\a], [\c]
        .endm
        .macro  \prefix\()pack_all k, a, c
        PACKV   \k, [\a], [\c]
        .endm
        .macro  \prefix\()pack_number e, k, c
        PACKV   [\e], \k, [\c]
        .endm
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
        .macro  \prefix\()unless_less_number a, k, label
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
        .macro  \prefix\()leaving k, l, c
        VTOV    \l, [\c]
        .endm
        .macro  \prefix\()leave_if_number_not_less k, a, m, c, label
        CMPGEV  \k, [\a], [\bits]
        VTOV    \m, [\c] ? [\bits]
        .endm
        .macro  \prefix\()staying l, c
        .endm
        .macro  \prefix\()otherwise end, label
        .endm
        .macro  \prefix\()end_if label
        .endm
        .macro  \prefix\()then_set k, c
        VTOV    \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_clear c
        VTOV    r0, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_copy a, c
        VTOV    [\a], [\c] ? [\bits]
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
        .macro  \prefix\()then_raise a, k, c
        ADDNV   [\a], \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_from k, a, c
        SUBNV   \k, [\a], [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_raise_index a, k, c
        ADDXV   [\a], \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_negate a, c
        SUBNV   r0, [\a], [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_scale a, k, c
        MPYSV   [\a], \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_lower a, k, c
        SUBNV   [\a], \k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_set_minus k, c
        VTOV    -\k, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_negate_index a, c
        SUBUV   r0, [\a], [\c] ? [\bits]
        .endm
        .macro  \prefix\()default k, c
        .endm
        .macro  \prefix\()then_set_or k, l, c
        MASKV   \k, \l, [\c] ? [\bits]
        .endm
        .macro  \prefix\()then_set_or_copy k, b, c
        MASKV   \k, [\b], [\c] ? [\bits]
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
        .endm

        .endif
