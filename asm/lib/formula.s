; formula.s - formulas that are written once and assembled in two forms: for
; numbers and for vectors.
;
; A formula is a macro whose first argument, form, is number or vector.
; It consists of the operations below, written \form\()_times and so on.
; Both forms execute the same operations in the same order, so their
; results are equal, bit for bit. The vector form links two operations
; into one stream where possible. It stores by control vector, where the
; form for numbers branches.
;
; In the list a, b, c are registers with numbers, or descriptors of vectors of
; the same length; k and l are numbers in both forms.
;
;       normal a, c             c = a, normalised
;       times a, b, c           c = a b           plus a, b, c        c = a + b
;       minus a, b, c           c = a - b         over a, b, c        c = a / b
;       shift a, k, c           c = a + k         scale a, k, c       c = a k
;       from k, a, c            c = k - a         magnitude a, c      c = |a|
;       line a, k, l, c         c = a k + l
;       step x, k, c            c = c x + k, a step of Horner's rule
;       add_scaled a, k, c      c = c + a k
;       scaled_plus a, k, b, c  c = b + a k
;       floor a, c              c = the largest integer not above a, exponent 0
;       exponent a, c           c = the exponent of a, an integer
;       add_index a, b, c       c = a + b of integers
;       shift_index a, k, c     c = a + k of integers
;       minus_index a, b, c     c = a - b of integers
;       upper_product a, b, c   c = the first 47 digits of a b
;       low_product a, b, c     c = the other digits of a b; for integers
;                               below 2^47 these are all digits
;       pick i, at, c           c = word i of a table; at: register with its
;                               address
;       pack e, a, c            c = the exponent e with the coefficient of a
;       pack_all k, a, c        the same with one exponent k for all elements
;       truncate a, c           c = the integer part of a, exponent 0
;       copy a, c               c = a
;       clear c                 c = 0, machine zero
;
; Conditions: for a vector, all operations between the condition and end_if
; label are computed for all elements. Operations then_.. are stored only for
; elements for which the condition is true. For an indefinite a it is false.
;
;       if_above a, b, label            is a > b?
;       if_above_number a, k, label     is a > k?
;       if_below_number a, k, label     is a < k?
;       if_equal_number a, k, label     is a = k?
;       if_beyond_number a, k, label    is |a| > k?
;       if_bit a, k, label              has the integer a the bit of k?
;       unless_above_number a, k, label is a > k false?
;       otherwise end, label            from here to end_if end: elements for
;                                       which the condition is false
;       then_set k, c      then_copy a, c            then_plus a, b, c
;       then_from k, a, c  then_shift a, k, c        then_shift_index a, k, c
;       then_negate a, c   then_negate_index a, c    then_clear c
;       otherwise_set k, c       if the condition is false
;       otherwise_copy a, c      if the condition is false
;
; Registers 208 to 255 belong to the library: docs/functions.md.

        .ifndef formula.s
        .equ    formula.s, 1

        .include "core.s"

        .regs   r208, f_link, f_target
        .regs   r210, f_x, f_y, f_r, f_s
        .regs   r214, f_0, f_1, f_2, f_3, f_4, f_5, f_6, f_7, f_8, f_9
        .regs   r224, f_linked, f_bits
        .regs   r226, f_strip_x, f_strip_y, f_strip_r, f_strip_s, f_left, f_n
        .share  functions
        .reg    f_constants, r232       ; up to r255
        .endshare

; Length of the strips into which the vector form splits a vector.
        .ifndef F_STRIP
        .equ    F_STRIP, 2048
        .endif
        .if     F_STRIP < 1 || F_STRIP > 65535
        .error  "F_STRIP is the length of a vector: 1 to 65535"
        .endif
        .equ    F_WORK, 10              ; vectors for intermediate results

        .data
f_work: .space  F_WORK * F_STRIP
        .bitvector f_work_bits, F_STRIP
        .code

; ---- Routines ----------------------------------------------------------------

; Defines the routines name and vname of a formula with the arguments form, x,
; y, r, s. A program that reaches them in sequence branches over them.
        .macro  routines name, formula
        BIM     \name\().over
        .kernel \name
\name: \formula number, f_x, f_y, f_r, f_s
        return  f_link
        .endkernel
        .kernel v\name
v\name:
        RTOR    f_x, f_strip_x
        RTOR    f_y, f_strip_y
        RTOR    f_r, f_strip_r
        RTOR    f_s, f_strip_s
        LTOR    f_r, f_left
        IBXEQ   f_left, r0, r0, v\name\().done
        EX      f_target, F_STRIP
v\name\().strip:
        RTOR    f_left, f_n
        IBXLE   f_left, r0, f_target, v\name\().fits
        RTOR    f_target, f_n
v\name\().fits:
        f_scratch  f_0, 0
        f_scratch  f_1, 1
        f_scratch  f_2, 2
        f_scratch  f_3, 3
        f_scratch  f_4, 4
        f_scratch  f_5, 5
        f_scratch  f_6, 6
        f_scratch  f_7, 7
        f_scratch  f_8, 8
        f_scratch  f_9, 9
        f_scratch  f_linked, 0          ; never stored
        EX      f_bits, f_work_bits
        ADDLEN  f_bits, f_n, f_bits
        f_length f_strip_x
        f_length f_strip_y
        f_length f_strip_r
        f_length f_strip_s
        \formula vector, f_strip_x, f_strip_y, f_strip_r, f_strip_s
        IX      f_strip_x, 64 * F_STRIP
        IX      f_strip_y, 64 * F_STRIP
        IX      f_strip_r, 64 * F_STRIP
        IX      f_strip_s, 64 * F_STRIP
        EX      f_target, F_STRIP
        SUBX    f_left, f_n, f_left
        IBXGT   f_left, r0, r0, v\name\().strip
v\name\().done:
        return  f_link
        .endkernel
\name\().over:
        .endm

        .macro  f_scratch vector, number
        EX      \vector, f_work + 64 * F_STRIP * \number
        ADDLEN  \vector, f_n, \vector
        .endm

        .macro  f_length vector
        ELEN    \vector, 0
        ADDLEN  \vector, f_n, \vector
        .endm

; The start of a formula: loads its constants, count words at name.constants.
        .macro  load_constants name, count
        EX      f_target, \name\().constants
        ELEN    f_target, \count
        SWAP    [f_target], f_constants, [r0]
        .endm

; r = routine(x), and r = routine(x, y), for numbers. For vectors x, y, r are
; descriptors, and the name of the routine begins with v.
        .macro  apply routine, x, r
        RTOR    \x, f_x
        RTOR    \r, f_r
        call    \routine, f_link, f_target
        RTOR    f_r, \r
        .endm
        .macro  apply_two routine, x, y, r
        RTOR    \y, f_y
        apply   \routine, \x, \r
        .endm

; ---- Operations on numbers ---------------------------------------------------

        .macro  number_normal a, c
        ADDN    \a, r0, \c
        .endm
        .macro  number_times a, b, c
        MPYS    \a, \b, \c
        .endm
        .macro  number_plus a, b, c
        ADDN    \a, \b, \c
        .endm
        .macro  number_minus a, b, c
        SUBN    \a, \b, \c
        .endm
        .macro  number_over a, b, c
        DIVS    \a, \b, \c
        .endm
        .macro  number_shift a, k, c
        ADDN    \a, \k, \c
        .endm
        .macro  number_scale a, k, c
        MPYS    \a, \k, \c
        .endm
        .macro  number_from k, a, c
        SUBN    \k, \a, \c
        .endm
        .macro  number_magnitude a, c
        ABS     \a, \c
        .endm
        .macro  number_line a, k, l, c
        MPYS    \a, \k, \c
        ADDN    \c, \l, \c
        .endm
        .macro  number_step x, k, c
        MPYS    \c, \x, \c
        ADDN    \c, \k, \c
        .endm
        .macro  number_add_scaled a, k, c
        number_scaled_plus \a, \k, \c, \c
        .endm
        .macro  number_scaled_plus a, k, b, c
        MPYS    \a, \k, f_linked
        ADDN    f_linked, \b, \c
        .endm
        .macro  number_floor a, c
        FLR     \a, \c
        .endm
        .macro  number_exponent a, c
        EXP     \a, \c
        .endm
        .macro  number_add_index a, b, c
        ADDX    \a, \b, \c
        .endm
        .macro  number_shift_index a, k, c
        ADDX    \a, \k, \c
        .endm
        .macro  number_minus_index a, b, c
        SUBX    \a, \b, \c
        .endm
        .macro  number_upper_product a, b, c
        MPYU    \a, \b, \c
        .endm
        .macro  number_low_product a, b, c
        MPYL    \a, \b, \c
        .endm
        .macro  number_pick i, at, c
        LOD     [\at, \i], \c
        .endm
        .macro  number_pack e, a, c
        PACK    \e, \a, \c
        .endm
        .macro  number_pack_all k, a, c
        PACK    \k, \a, \c
        .endm
        .macro  number_truncate a, c
        TRU     \a, \c
        .endm
        .macro  number_copy a, c
        RTOR    \a, \c
        .endm
        .macro  number_clear c
        ADDN    r0, r0, \c
        .endm

        .macro  number_if_above a, b, label
        CFPLE   \a, \b, \label
        CFPNE   \a, \a, \label
        .endm
        .macro  number_if_above_number a, k, label
        number_if_above \a, \k, \label
        .endm
        .macro  number_if_below_number a, k, label
        CFPGE   \a, \k, \label
        CFPNE   \a, \a, \label
        .endm
        .macro  number_if_equal_number a, k, label
        CFPNE   \a, \k, \label
        .endm
        .macro  number_if_beyond_number a, k, label
        ABS     \a, f_linked
        number_if_above f_linked, \k, \label
        .endm
        .macro  number_if_bit a, k, label
        AND     \a, \k, f_linked
        CFPEQ   f_linked, r0, \label
        .endm
        .macro  number_unless_above_number a, k, label
        CFPGT   \a, \k, \label
        .endm
        .macro  number_otherwise end, label
        BIM     \end
\label:
        .endm
        .macro  number_end_if label
\label:
        .endm
        .macro  number_then_set k, c
        RTOR    \k, \c
        .endm
        .macro  number_then_clear c
        number_clear \c
        .endm
        .macro  number_then_copy a, c
        RTOR    \a, \c
        .endm
        .macro  number_otherwise_set k, c
        RTOR    \k, \c
        .endm
        .macro  number_otherwise_copy a, c
        RTOR    \a, \c
        .endm
        .macro  number_then_plus a, b, c
        ADDN    \a, \b, \c
        .endm
        .macro  number_then_shift a, k, c
        ADDN    \a, \k, \c
        .endm
        .macro  number_then_from k, a, c
        SUBN    \k, \a, \c
        .endm
        .macro  number_then_shift_index a, k, c
        ADDX    \a, \k, \c
        .endm
        .macro  number_then_negate a, c
        SUBN    r0, \a, \c
        .endm
        .macro  number_then_negate_index a, c
        SUBU    r0, \a, \c
        .endm

; ---- Operations on vectors ---------------------------------------------------

        .macro  vector_normal a, c
        ADDNV   [\a], r0, [\c]
        .endm
        .macro  vector_times a, b, c
        MPYSV   [\a], [\b], [\c]
        .endm
        .macro  vector_plus a, b, c
        ADDNV   [\a], [\b], [\c]
        .endm
        .macro  vector_minus a, b, c
        SUBNV   [\a], [\b], [\c]
        .endm
        .macro  vector_over a, b, c
        DIVSV   [\a], [\b], [\c]
        .endm
        .macro  vector_shift a, k, c
        ADDNV   [\a], \k, [\c]
        .endm
        .macro  vector_scale a, k, c
        MPYSV   [\a], \k, [\c]
        .endm
        .macro  vector_from k, a, c
        SUBNV   \k, [\a], [\c]
        .endm
        .macro  vector_magnitude a, c
        ABSV    [\a], [\c]
        .endm
        .macro  vector_line a, k, l, c
        LINKV
        MPYSV   [\a], \k, [f_linked]
        ADDNV   [f_linked], \l, [\c]
        .endm
        .macro  vector_step x, k, c
        LINKV
        MPYSV   [\c], [\x], [f_linked]
        ADDNV   [f_linked], \k, [\c]
        .endm
        .macro  vector_add_scaled a, k, c
        vector_scaled_plus \a, \k, \c, \c
        .endm
        .macro  vector_scaled_plus a, k, b, c
        LINKV
        MPYSV   [\a], \k, [f_linked]
        ADDNV   [f_linked], [\b], [\c]
        .endm
        .macro  vector_floor a, c
        FLRV    [\a], [\c]
        .endm
        .macro  vector_exponent a, c
        EXPV    [\a], [\c]
        .endm
        .macro  vector_add_index a, b, c
        ADDXV   [\a], [\b], [\c]
        .endm
        .macro  vector_shift_index a, k, c
        ADDXV   [\a], \k, [\c]
        .endm
        .macro  vector_minus_index a, b, c
        SUBXV   [\a], [\b], [\c]
        .endm
        .macro  vector_upper_product a, b, c
        MPYUV   [\a], [\b], [\c]
        .endm
        .macro  vector_low_product a, b, c
        MPYLV   [\a], [\b], [\c]
        .endm
        .macro  vector_pick i, at, c
        VXTOV   [\i], [\at], [\c]
        .endm
        .macro  vector_pack e, a, c
        PACKV   [\e], [\a], [\c]
        .endm
        .macro  vector_pack_all k, a, c
        PACKV   \k, [\a], [\c]
        .endm
        .macro  vector_truncate a, c
        TRUV    [\a], [\c]
        .endm
        .macro  vector_copy a, c
        VTOV    [\a], [\c]
        .endm
        .macro  vector_clear c
        VTOV    r0, [\c]
        .endm

        .macro  vector_if_above a, b, label
        CMPLTV  [\b], [\a], [f_bits]
        .endm
        .macro  vector_if_above_number a, k, label
        CMPLTV  \k, [\a], [f_bits]
        .endm
        .macro  vector_if_below_number a, k, label
        CMPLTV  [\a], \k, [f_bits]
        .endm
        .macro  vector_if_equal_number a, k, label
        CMPEQV  [\a], \k, [f_bits]
        .endm
        .macro  vector_if_beyond_number a, k, label
        CMPLTV  \k, |[\a]|, [f_bits]
        .endm
        .macro  vector_if_bit a, k, label
        LINKV
        ANDV    [\a], \k, [f_linked]
        CMPNEV  [f_linked], r0, [f_bits]
        .endm
        .macro  vector_unless_above_number a, k, label
        CMPLTV  \k, [\a], [f_bits]
        .endm
        .macro  vector_otherwise end, label
        .endm
        .macro  vector_end_if label
        .endm
        .macro  vector_then_set k, c
        VTOV    \k, [\c] ? [f_bits]
        .endm
        .macro  vector_then_clear c
        VTOV    r0, [\c] ? [f_bits]
        .endm
        .macro  vector_then_copy a, c
        VTOV    [\a], [\c] ? [f_bits]
        .endm
        .macro  vector_otherwise_set k, c
        VTOV    \k, [\c] ?! [f_bits]
        .endm
        .macro  vector_otherwise_copy a, c
        VTOV    [\a], [\c] ?! [f_bits]
        .endm
        .macro  vector_then_plus a, b, c
        ADDNV   [\a], [\b], [\c] ? [f_bits]
        .endm
        .macro  vector_then_shift a, k, c
        ADDNV   [\a], \k, [\c] ? [f_bits]
        .endm
        .macro  vector_then_from k, a, c
        SUBNV   \k, [\a], [\c] ? [f_bits]
        .endm
        .macro  vector_then_shift_index a, k, c
        ADDXV   [\a], \k, [\c] ? [f_bits]
        .endm
        .macro  vector_then_negate a, c
        SUBNV   r0, [\a], [\c] ? [f_bits]
        .endm
        .macro  vector_then_negate_index a, c
        SUBUV   r0, [\a], [\c] ? [f_bits]
        .endm

        .endif
