; divide.s - divide and vdivide: f_r = the quotient of the integers f_x and
; f_y, truncated towards zero; f_s = the remainder, with the sign of f_x.
; f_s is a descriptor, too, if the operands are vectors.
;
;   q = the integer part of |x| / |y|,  |x| = q |y| + |s|
;
; Floating-point numbers are first truncated to integers. A quotient is
; truncated to 47 digits towards zero, so its integer part is exact. Both
; results are indefinite if f_y is 0 or an operand has more than 47 digits.
;
; Source: derived for this format.

        .ifndef divide.s
        .equ    divide.s, 1

        .include "functions.s"

        .share  functions
        .regs   r232, divide_zero, divide_most, divide_indefinite
        .endshare
        .equ    DIVIDE_CONSTANTS, 3

        .data
divide.constants:
        .word   0, 140737488355328.0, X'7000 0000 0000 0000'
        .code

        .macro  divide_formula form, x, y, r, s
        load_constants divide, DIVIDE_CONSTANTS
        \form\()_normal \x, f_0
        \form\()_normal \y, f_1
        \form\()_absolute f_0, f_8
        \form\()_absolute f_1, f_9
        \form\()_truncate f_8, f_5
        \form\()_truncate f_9, f_6
        \form\()_pack_exponent divide_zero, f_5, f_5    ; integers, also where it is machine zero
        \form\()_pack_exponent divide_zero, f_6, f_6
        \form\()_normal f_5, f_2
        \form\()_normal f_6, f_3
        \form\()_quotient f_2, f_3, f_4
        \form\()_truncate f_4, f_4
        \form\()_pack_exponent divide_zero, f_4, f_4    ; q
        \form\()_low_product f_4, f_6, f_6
        \form\()_minus_index f_5, f_6, \s
        \form\()_if_below_number f_0, r0, divide_rest\@
        \form\()_then_negate_index \s, \s
        \form\()_end_if divide_rest\@
        \form\()_copy f_4, \r
        \form\()_times f_0, f_1, f_7
        \form\()_if_below_number f_7, r0, divide_signs\@
        \form\()_then_negate_index f_4, \r
        \form\()_end_if divide_signs\@
        \form\()_from divide_most, f_8, f_8
        \form\()_unless_above_number f_8, r0, divide_short\@
        \form\()_otherwise_set divide_indefinite, \r
        \form\()_otherwise_set divide_indefinite, \s
        \form\()_end_if divide_short\@
        \form\()_from divide_most, f_9, f_9
        \form\()_unless_above_number f_9, r0, divide_shorter\@
        \form\()_otherwise_set divide_indefinite, \r
        \form\()_otherwise_set divide_indefinite, \s
        \form\()_end_if divide_shorter\@
        \form\()_unless_above_number f_3, r0, divide_good\@
        \form\()_otherwise_set divide_indefinite, \r
        \form\()_otherwise_set divide_indefinite, \s
        \form\()_end_if divide_good\@
        .endm

        routines divide, divide_formula

        .endif
