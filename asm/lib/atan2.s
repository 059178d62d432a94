; atan2.s - atan2 and vatan2: f_r = the angle of a point in radians, from -pi
; to pi. Its ordinate is f_x and its abscissa f_y; the ordinate is first, as in
; ATAN2 of FORTRAN.
;
;   n = min(|x|, |y|),  d = max(|x|, |y|)
;   t = (n - d) / (n + d), a = pi/4  if n > tan(pi/8) d;  else t = n / d, a = 0
;   b = a + atan t = a + t + t^3 A(t^2),  |t| <= tan(pi/8)
;
; The angle is b, or pi/2 - b if |ordinate| > |abscissa|. A negative abscissa
; replaces it by pi minus the angle. A negative ordinate then negates it. A
; interpolates (atan t - t) / t^3 at the ten Chebyshev points of t^2. Each
; constant that is added to b is a sum of two parts. The result is indefinite
; for the origin and for indefinite operands.
;
; Source: textbook; parts and polynomial are derived for this format.

        .ifndef atan2.s
        .equ    atan2.s, 1

        .include "functions.s"

        .share  functions
        .regs   r232, atan_eighth, atan_minus_one, atan_quarter, atan_low_of_one
        .regs   r236, atan_half, atan_half_low, atan_pi, atan_pi_low
        .regs   r240, atan_0, atan_1, atan_2, atan_3, atan_4, atan_5, atan_6, atan_7, atan_8, atan_9
        .endshare
        .equ    ATAN2_CONSTANTS, 18

        .data
atan2.constants:
        .word   0.41421356237309504880169       ; tan(pi/8)
        .word   -1.0
        .word   X'FFD1 6487 ED51 10B4'          ; pi/4
        .word   X'FFA1 4D9E B2E6 0A6A'          ; second part of pi/4, relative to 1
        .word   X'FFD2 6487 ED51 10B4', X'FFA2 611A 6263 3146'  ; pi/2
        .word   X'FFD3 6487 ED51 10B4', X'FFA3 611A 6263 3146'  ; pi
atan2.polynomial:
        .word   -3.3333333333333246249687e-01, 1.9999999999898408129678e-01
        .word   -1.4285714266096617917217e-01, 1.1111109636534361442486e-01
        .word   -9.0908525571760493568125e-02, 7.6910551583931492597677e-02
        .word   -6.6496136952916693628292e-02, 5.7363321659076426208037e-02
        .word   -4.4833346222728864488823e-02, 2.2750526993361677132301e-02
        .code

        .macro  atan2_formula form, x, y, r, s
        load_constants atan2, ATAN2_CONSTANTS
        \form\()_normal \x, f_0
        \form\()_normal \y, f_1
        \form\()_absolute f_0, f_2
        \form\()_absolute f_1, f_3
        \form\()_copy f_2, f_4                          ; n
        \form\()_copy f_3, f_5                          ; d
        \form\()_if_above f_2, f_3, atan_steep\@
        \form\()_then_copy f_3, f_4
        \form\()_then_copy f_2, f_5
        \form\()_end_if atan_steep\@
        \form\()_clear f_9                               ; a
        \form\()_scale f_5, atan_eighth, f_6
        \form\()_if_above f_4, f_6, atan_near\@
        \form\()_minus f_4, f_5, f_7
        \form\()_plus f_4, f_5, f_8
        \form\()_then_copy f_7, f_4
        \form\()_then_copy f_8, f_5
        \form\()_then_set atan_quarter, f_9
        \form\()_end_if atan_near\@
        \form\()_quotient f_4, f_5, f_4                     ; t
        \form\()_times f_4, f_4, f_5
        \form\()_line f_5, atan_9, atan_8, f_6
        \form\()_step f_5, atan_7, f_6
        \form\()_step f_5, atan_6, f_6
        \form\()_step f_5, atan_5, f_6
        \form\()_step f_5, atan_4, f_6
        \form\()_step f_5, atan_3, f_6
        \form\()_step f_5, atan_2, f_6
        \form\()_step f_5, atan_1, f_6
        \form\()_step f_5, atan_0, f_6                  ; A
        \form\()_times f_6, f_5, f_6
        \form\()_times f_6, f_4, f_6
        \form\()_scaled_plus f_9, atan_low_of_one, f_6, f_6
        \form\()_plus f_6, f_4, f_6
        \form\()_plus f_6, f_9, \r                      ; b
        \form\()_if_above f_2, f_3, atan_turned\@
        \form\()_then_from atan_half_low, \r, \r
        \form\()_then_raise \r, atan_half, \r
        \form\()_end_if atan_turned\@
        \form\()_if_below_number f_1, r0, atan_left\@
        \form\()_then_from atan_pi_low, \r, \r
        \form\()_then_raise \r, atan_pi, \r
        \form\()_end_if atan_left\@
        \form\()_if_below_number f_0, r0, atan_below\@
        \form\()_then_negate \r, \r
        \form\()_end_if atan_below\@
        .endm

        routines atan2, atan2_formula

        .endif
