; sin.s - sin, cos, vsin, vcos: f_r = the sine or cosine of f_x, in radians.
;
;   k = floor(x 2/pi + 1/2),  r + d = x - k pi/2,  |r| <= pi/4
;   sin r = r + (r^3 S(r^2) + d),  cos r = 1 - r^2 / 2 + r^4 C(r^2)
;
; d is the part of the difference that r cannot represent. The sine of x is sin
; r, cos r, -sin r, -cos r for k mod 4 = 0, 1, 2, 3. The cosine increases k by
; 1. pi/2 is the sum of four parts. The first three have 24 digits, so their
; products with k are exact. x minus one or two of these products is exact,
; too. S and C are in series.s.
;
; The result is indefinite if x is indefinite, or if |x| is above 2^23 pi/2,
; because k then has too many digits.
;
; Source: the method is textbook (W. J. Cody and W. Waite, Software
; Manual for the Elementary Functions, 1980); parts and polynomials are
; derived for this format.

        .ifndef sin.s
        .equ    sin.s, 1

        .include "functions.s"
        .include "series.s"

        .share  functions
        .regs   r232, sin_most, sin_indefinite, sin_two_over_pi, sin_half
        .regs   r236, sin_part_0, sin_part_1, sin_part_2, sin_part_3, sin_1, sin_2
        .regs   r242, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6
        .regs   r249, sin_one, sin_minus_half, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4
        .endshare
        .equ    SIN_CONSTANTS, 24

        .data
sin.constants:
        .word   13176794.0                      ; largest integer < 2^23 pi/2
        .word   X'7000 0000 0000 0000'
        .word   0.63661977236758134307554       ; 2 / pi
        .word   0.5
        .word   X'FFD2 9B78 1300 0000'          ; -pi/2, first 24 digits
        .word   X'FFBA AEEF 4C00 0000'          ; the next 24 digits
        .word   X'FFA2 9EE5 9E00 0000'          ; the next 24 digits
        .word   X'FF8A 9CCE BA3F 91F2'          ; the remaining digits
        .word   1, 2
sin.polynomial:
        sine_coefficients
        .word   1.0, -0.5
cos.polynomial:
        cosine_coefficients
        .code

        .macro  quarter_turns form, x
        load_constants sin, SIN_CONSTANTS
        \form\()_normal \x, f_0
        \form\()_if_beyond_number f_0, sin_most, sin_most\@
        \form\()_then_set sin_indefinite, f_0
        \form\()_end_if sin_most\@
        \form\()_line f_0, sin_two_over_pi, sin_half, f_1
        \form\()_floor f_1, f_1                         ; k
        \form\()_normal f_1, f_2
        \form\()_scaled_plus_two f_2, sin_part_0, f_0, f_0, f_2, sin_part_1, f_0, f_0
        \form\()_scale f_2, sin_part_2, f_3
        \form\()_plus f_0, f_3, f_4                     ; r
        .endm

        .macro  sine_of_quarter form, r
        \form\()_times f_4, f_4, f_7
        \form\()_if_bit f_1, sin_1, sin_even\@
        cosine_of_rest \form\()_, f_7, \r
        \form\()_otherwise sin_end\@, sin_even\@
        \form\()_minus f_0, f_4, f_0
        \form\()_plus f_0, f_3, f_0
        \form\()_scaled_plus f_2, sin_part_3, f_0, f_5  ; d
        sine_polynomial \form\()_, f_7, f_6
        \form\()_times f_6, f_7, f_6
        \form\()_times f_6, f_4, f_6
        \form\()_plus f_6, f_5, f_6
        \form\()_otherwise_plus f_6, f_4, \r          ; sin r
        \form\()_end_if sin_end\@
        \form\()_if_bit f_1, sin_2, sin_upper\@
        \form\()_then_negate \r, \r
        \form\()_end_if sin_upper\@
        .endm

        .macro  sin_formula form, x, y, r, s
        quarter_turns \form, \x
        sine_of_quarter \form, \r
        .endm

        .macro  cos_formula form, x, y, r, s
        quarter_turns \form, \x
        \form\()_raise_index f_1, sin_1, f_1
        sine_of_quarter \form, \r
        .endm

        routines sin, sin_formula
        routines cos, cos_formula

        .endif
