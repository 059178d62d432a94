; log.s - log and vlog: f_r = ln f_x.
;
;   x = 2^k f,  sqrt(1/2) <= f < sqrt(2),  g = f - 1,  s = g / (1 + f)
;   ln f = 2 artanh s = g - s (g - s^2 R(s^2)),  ln x = k ln 2 + ln f
;
; Near 1 the first term, g, is exact. R is in series.s. f is x with another
; exponent. ln 2 is the sum of two parts. The first part has 32 digits, so its
; product with k is exact. The result is indefinite if x is indefinite or not
; above 0.
;
; Source: the method is textbook (W. J. Cody and W. Waite, Software
; Manual for the Elementary Functions, 1980); parts and polynomial are
; derived for this format.

        .ifndef log.s
        .equ    log.s, 1

        .include "functions.s"
        .include "series.s"

        .share  functions
        .regs   r232, log_47, log_minus_47, log_minus_1, log_root_half, log_one, log_minus_one
        .regs   r238, log_ln2_high, log_ln2_low, log_indefinite
        .regs   r241, log_0, log_1, log_2, log_3, log_4, log_5
        .endshare
        .equ    LOG_CONSTANTS, 15

        .data
log.constants:
        .word   47, -47, -1
        .word   0.7071067811865475244008        ; sqrt(1/2)
        .word   1.0, -1.0
        .word   X'FFD1 58B9 0BFB 8000'          ; ln 2, first 32 digits
        .word   X'FFB1 68E7 BCD5 E4F2'          ; the remaining digits
        .word   X'7000 0000 0000 0000'
log.polynomial:
        log_coefficients
        .code

        .macro  log_formula form, x, y, r, s
        load_constants log, LOG_CONSTANTS
        \form\()_normal \x, f_0
        \form\()_exponent f_0, f_1
        \form\()_raise_index f_1, log_47, f_1           ; k
        \form\()_pack_exponent log_minus_47, f_0, f_2   ; f, from 1/2 to 1
        \form\()_if_below_number f_2, log_root_half, log_low\@
        \form\()_then_plus f_2, f_2, f_2
        \form\()_then_raise_index f_1, log_minus_1, f_1
        \form\()_end_if log_low\@
        \form\()_raise f_2, log_minus_one, f_3          ; g
        \form\()_raise f_2, log_one, f_4
        \form\()_quotient f_3, f_4, f_4                     ; s
        \form\()_times f_4, f_4, f_5
        log_polynomial \form\()_, f_5, f_6                ; R
        \form\()_times f_6, f_5, f_6
        \form\()_minus f_3, f_6, f_6
        \form\()_times f_6, f_4, f_6
        \form\()_minus f_3, f_6, f_6                    ; ln f
        \form\()_normal f_1, f_1
        \form\()_scaled_plus f_1, log_ln2_low, f_6, f_6
        \form\()_scaled_plus f_1, log_ln2_high, f_6, \r
        \form\()_unless_above_number f_0, r0, log_good\@
        \form\()_otherwise_set log_indefinite, \r
        \form\()_end_if log_good\@
        .endm

        routines log, log_formula

        .endif
