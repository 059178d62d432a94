; power.s - power and vpower: f_r = f_x ^ f_y.
;
;   x = 2^k f, 1 <= f < 2,  j = floor(32 f - 31.5), from 0 to 32
;   f c(j) = 1 + q, |q| < 1/32
;   c(j) = 32 / (32 + j), rounded to 64ths
;   log2 x = A + B,  A = k + H(j),  B = L(j) + q / ln 2 + q^2 P(q)
;   P(q) = (log2(1 + q) - q / ln 2) / q^2
;   z = y A + y B,  n = floor(z + 1/2),  x^y = 2^n e^((z - n) ln 2)
;
; H + L = -log2 c. H has 30 binary digits after the point, so A and q are
; exact. The product y A has double length. Subtracting n from it leaves its
; last digits. Powers of two are therefore exact, and other results lose digits
; only if y is above 32. P is a polynomial that interpolates at the seven
; Chebyshev points from -1/32 to 1/32. exp.s computes the exponential.
;
; The result is machine zero if x = 0 and y is above 0. It is indefinite for
; indefinite operands and for any other x that is not above 0.
;
; Source: the method is textbook (P. T. P. Tang, "Table-driven implementation
; of the logarithm function in IEEE floating-point arithmetic", 1990); tables
; and polynomial are derived for this format.

        .ifndef power.s
        .equ    power.s, 1

        .include "exp.s"

        .share  functions
        .regs   r232, power_46, power_minus_46, power_one, power_minus_one, power_32, power_start
        .regs   r238, power_half, power_per_ln2, power_ln2
        .regs   r241, power_0, power_1, power_2, power_3, power_4, power_5, power_6
        .regs   r248, power_most, power_least, power_indefinite  ; unchanged by exp.s
        .reg    power_table, r251
        .endshare
        .equ    POWER_CONSTANTS, 19

        .data
power.constants:
        .word   46, -46
        .word   1.0, -1.0, 32.0, -31.5, 0.5
        .word   1.4426950408889634073599        ; 1 / ln 2
        .word   0.69314718055994530941723       ; ln 2
power.polynomial:
        .word   -7.2134752044448170367996e-01, 4.8089834697933930570231e-01
        .word   -3.6067376023695758596695e-01, 2.8853887423965720808603e-01
        .word   -2.4044905293427237746477e-01, 2.0637351466688568093093e-01
        .word   -1.8058368547856782748434e-01
        .word   28800.0, -28800.0, X'7000 0000 0000 0000'
; The tables c, H and L for j = 0 .. 32. First table c.
power.factors:
        .word   1.0, 0.96875, 0.9375, 0.921875, 0.890625, 0.859375, 0.84375, 0.828125, 0.796875, 0.78125, 0.765625
        .word   0.75, 0.734375, 0.71875, 0.703125, 0.6875, 0.671875, 0.65625, 0.640625, 0.625, 0.609375, 0.609375
        .word   0.59375, 0.578125, 0.578125, 0.5625, 0.546875, 0.546875, 0.53125, 0.53125, 0.515625, 0.515625, 0.5
; Table H
power.high:
        .word   X'8000 0000 0000 0000', X'FFCD 5DCE 5320 0000', X'FFCE 5F58 1250 0000'
        .word   X'FFCE 782C 6BA0 0000', X'FFCF 558F 70A0 0000', X'FFCF 6FF1 9E98 0000'
        .word   X'FFCF 7D7F 62A0 0000', X'FFD0 45A7 014C 0000', X'FFD0 53DB EEC8 0000'
        .word   X'FFD0 5B2C 3DA0 0000', X'FFD0 62A2 6028 0000', X'FFD0 6A3F E5C4 0000'
        .word   X'FFD0 7206 7708 0000', X'FFD0 79F7 D7F8 0000', X'FFD1 410A F52E 0000'
        .word   X'FFD1 4531 583E 0000', X'FFD1 4970 2810 0000', X'FFD1 4DC8 8AEC 0000'
        .word   X'FFD1 523B BC64 0000', X'FFD1 56CB 0F68 0000', X'FFD1 5B77 F0A8 0000'
        .word   X'FFD1 5B77 F0A8 0000', X'FFD1 6043 E946 0000', X'FFD1 6530 A1D2 0000'
        .word   X'FFD1 6530 A1D2 0000', X'FFD1 6A3F E5C6 0000', X'FFD1 6F73 A772 0000'
        .word   X'FFD1 6F73 A772 0000', X'FFD1 74CE 0482 0000', X'FFD1 74CE 0482 0000'
        .word   X'FFD1 7A51 4B22 0000', X'FFD1 7A51 4B22 0000', X'FFD2 4000 0000 0000'
; Table L
power.low:
        .word   X'8000 0000 0000 0000', X'FFB1 7656 3557 7970', X'FFB3 59F7 698C E768'
        .word   X'FFB1 797E AB32 59D2', X'FFB3 7FEB 2C83 21C8', X'FFB3 7FFD 3301 BC0A'
        .word   X'FFB3 418F 8D24 23FB', X'FFB2 63F1 5872 350F', X'FFB3 6762 CC3C 7274'
        .word   X'FFB2 65C8 EA03 6DA8', X'FFB3 5FDE 9933 354D', X'FFB3 4085 2F0C 0BFE'
        .word   X'FFB3 6A2F F21C 4AEC', X'FFB2 538A B34E FB51', X'FFB1 69F2 6263 CD9C'
        .word   X'FFB3 668A F880 E0A0', X'FFB3 63BE AFAD F5C8', X'FFB3 7074 7BA5 A6A5'
        .word   X'FFB2 62F3 21A8 72AD', X'FFB1 65C8 EA03 6DA8', X'FFB3 78FC 633E DD23'
        .word   X'FFB3 78FC 633E DD23', X'FFB2 7ECB FAEE 2B93', X'FFB1 4B13 6C10 1EE1'
        .word   X'FFB1 4B13 6C10 1EE1', X'FFAD 4297 8605 FF4E', X'FFB3 4961 871A 7610'
        .word   X'FFB3 4961 871A 7610', X'FFB2 4DBB 3A60 CCEB', X'FFB2 4DBB 3A60 CCEB'
        .word   X'FFB2 4E20 4F19 D93F', X'FFB2 4E20 4F19 D93F', X'8000 0000 0000 0000'
        .code

        .macro  power_formula form, x, y, r, s
        load_constants power, POWER_CONSTANTS
        \form\()_normal \x, f_8
        \form\()_normal \y, f_9
        \form\()_absolute f_8, f_2
        \form\()_exponent f_2, f_1
        \form\()_raise_index f_1, power_46, f_1         ; k
        \form\()_pack_exponent power_minus_46, f_2, f_2
        \form\()_if_below_number f_2, power_one, power_zero\@
        \form\()_then_set power_one, f_2
        \form\()_end_if power_zero\@                   ; f, and 1 where x is 0
        \form\()_line f_2, power_32, power_start, f_3
        \form\()_floor f_3, f_3                         ; j
        EX      power_table, power.factors
        \form\()_gather f_3, power_table, f_4
        EX      power_table, power.high
        \form\()_gather f_3, power_table, f_5
        EX      power_table, power.low
        \form\()_gather f_3, power_table, f_6
        \form\()_upper_product f_2, f_4, f_7
        \form\()_low_product f_2, f_4, f_4
        \form\()_raise f_7, power_minus_one, f_7
        \form\()_plus f_7, f_4, f_7                     ; q
        \form\()_line f_7, power_6, power_5, f_2
        \form\()_step f_7, power_4, f_2
        \form\()_step f_7, power_3, f_2
        \form\()_step f_7, power_2, f_2
        \form\()_step f_7, power_1, f_2
        \form\()_step f_7, power_0, f_2
        \form\()_times f_2, f_7, f_2
        \form\()_times f_2, f_7, f_2
        \form\()_scaled_plus f_7, power_per_ln2, f_2, f_2
        \form\()_plus f_2, f_6, f_2                     ; B
        \form\()_normal f_1, f_1
        \form\()_plus f_1, f_5, f_1                     ; A
        \form\()_upper_product f_9, f_1, f_3
        \form\()_low_product f_9, f_1, f_4
        \form\()_times f_9, f_2, f_2
        \form\()_plus f_3, f_2, f_5                     ; z
        \form\()_raise f_5, power_half, f_1
        \form\()_if_above_number f_1, power_most, power_most\@
        \form\()_then_set power_most, f_1
        \form\()_end_if power_most\@
        \form\()_if_below_number f_1, power_least, power_least\@
        \form\()_then_set power_least, f_1
        \form\()_end_if power_least\@
        \form\()_floor f_1, f_1                         ; n
        \form\()_normal f_1, f_0
        \form\()_minus f_3, f_0, f_3
        \form\()_plus f_3, f_4, f_3
        \form\()_plus f_3, f_2, f_3
        \form\()_scale f_3, power_ln2, f_0              ; (z - n) ln 2
        load_constants exp, EXP_CONSTANTS
        exp_of_rest \form\()_, f_0, f_1, f_2, f_3, \r
        \form\()_if_above_number f_5, power_most, power_over\@
        \form\()_then_set power_indefinite, \r
        \form\()_end_if power_over\@
        \form\()_if_below_number f_5, power_least, power_under\@
        \form\()_then_clear \r
        \form\()_end_if power_under\@
        \form\()_unless_above_number f_8, r0, power_good\@
        \form\()_otherwise_set power_indefinite, \r
        \form\()_end_if power_good\@
        \form\()_clear f_6
        \form\()_if_equal_number f_8, r0, power_of_zero\@
        \form\()_then_copy f_9, f_6
        \form\()_end_if power_of_zero\@
        \form\()_if_above_number f_6, r0, power_none\@
        \form\()_then_clear \r
        \form\()_end_if power_none\@
        .endm

        routines power, power_formula

        .endif
