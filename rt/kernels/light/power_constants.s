; power_constants.s - registers and constants of x^y (power.s) and of the
; polynomials.  The registers are loaded once and are the same in both forms.

        .include "series.s"

        .reg    exponent, r200
        .regs   r201, p_47, p_minus_47, p_root_half, p_per_ln2, p_ln2, p_floor
        .regs   r207, exp_0, exp_1, exp_2, exp_3, exp_4, exp_5, exp_6, exp_7, exp_8
        .regs   r216, log_0, log_1, log_2, log_3, log_4, log_5
        .regs   r222, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6
        .reg    p_fraction, r229
        .equ    POWER_CONSTANTS, 29

        .data
power_constants:
        .word 47, -47
        .word 0.70710678118654752440    ; sqrt(1/2)
        .word 1.44269504088896340736    ; 1 / ln 2
        .word 0.69314718055994530942    ; ln 2
        .word -1000.0                   ; 2^-1000 counts as 0
        exp_coefficients
        log_coefficients
        sine_coefficients
        .word X'0000 FFFF FFFF FFFF'    ; the coefficient of a word
        .code
