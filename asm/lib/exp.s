; exp.s - exp and vexp: f_r = e^f_x.
;
;   k = floor(x / ln 2 + 1/2),  r = x - k ln 2,  |r| <= ln 2 / 2
;   e^r = 1 + r + r^2 Q(r),  e^x = 2^k e^r
;
; ln 2 is the sum of two parts. The first part has 32 digits, so its product
; with k is exact. Q is in series.s. Adding k to the exponent multiplies by
; 2^k. A result that is too small is machine zero. A result that is too large is
; indefinite, and so is the result for an indefinite operand.
;
; Source: the method is textbook (W. J. Cody and W. Waite, Software
; Manual for the Elementary Functions, 1980); parts and polynomial are
; derived for this format.

        .ifndef exp.s
        .equ    exp.s, 1

        .include "functions.s"
        .include "series.s"

        .share  functions
        .regs   r232, exp_least, exp_most, exp_per_ln2, exp_half, exp_ln2_high, exp_ln2_low
        .regs   r238, exp_one, exp_0, exp_1, exp_2, exp_3, exp_4, exp_5, exp_6, exp_7, exp_8
        .endshare
        .equ    EXP_CONSTANTS, 16

        .data
exp.constants:
        .word   -20000.0, 20000.0
        .word   1.4426950408889634073599        ; 1 / ln 2
        .word   0.5
        .word   X'FFD1 A746 F404 8000'          ; -ln 2, first 32 digits
        .word   X'FFB1 9718 432A 1B0E'          ; the remaining digits
        .word   1.0
exp.polynomial:
        exp_coefficients
        .code

        .macro  exp_formula form, x, y, r, s
        load_constants exp, EXP_CONSTANTS
        \form\()_normal \x, f_0
        \form\()_if_below_number f_0, exp_least, exp_least\@
        \form\()_then_set exp_least, f_0
        \form\()_end_if exp_least\@
        \form\()_if_above_number f_0, exp_most, exp_most\@
        \form\()_then_set exp_most, f_0
        \form\()_end_if exp_most\@
        \form\()_line f_0, exp_per_ln2, exp_half, f_1
        \form\()_floor f_1, f_1                         ; k
        \form\()_normal f_1, f_2
        \form\()_scaled_plus_two f_2, exp_ln2_high, f_0, f_0, f_2, exp_ln2_low, f_0, f_0 ; r
        exp_of_rest \form\()_, f_0, f_1, f_2, f_3, \r
        .endm

        routines exp, exp_formula

        .endif
