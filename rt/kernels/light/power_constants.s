; power_constants.s - registers and constants of x^y (power_vector.s,
; power_scalar.s).  The registers are loaded once and are the same in the scalar
; and the vector form.

        .reg    exponent, r200
        .regs   r201, p_fraction, p_scale, p_upper, p_unit, p_47, p_minus_46
        .regs   r207, p_48
        .regs   r208, p_root_half, p_two_over_ln2, p_ln2, p_root_two, p_floor
        .regs   r213, log3, log5, log7, log9, log11, log13, log15, log17
        .regs   r221, exp2, exp3, exp4, exp5, exp6, exp7, exp8, exp9, exp10
        .regs   r230, exp11, exp12, exp13
        .equ    POWER_CONSTANTS, 32

; 1 + x/3 + x^2/5 + .. + x^8/17, in the register or vector of horner.
        .macro  log_series x, unit
        horner_start \x, log17, log15
        horner  \x, log13
        horner  \x, log11
        horner  \x, log9
        horner  \x, log7
        horner  \x, log5
        horner  \x, log3
        horner  \x, \unit
        .endm

        .data
power_constants:
        .word X'0000 FFFF FFFF FFFF'    ; the coefficient of a word
        .word X'FFD1 0000 0000 0000'    ; exponent -47
        .word X'FFFF 0000 0000 0000'    ; the exponent of a word
        .word X'0000 4000 0000 0000'    ; coefficient 2^46
        .word 47, -46, 48
        .word 0.70710678118654752440    ; sqrt(1/2)
        .word 2.88539008177792681472    ; 2 / ln 2
        .word 0.69314718055994530942    ; ln 2
        .word 1.41421356237309504880    ; sqrt(2)
        .word -1000.0                   ; 2^-1000 counts as 0
        .word 0.33333333333333333333    ; 1/3
        .word 0.2
        .word 0.14285714285714285714    ; 1/7
        .word 0.11111111111111111111    ; 1/9
        .word 0.09090909090909090909    ; 1/11
        .word 0.07692307692307692308    ; 1/13
        .word 0.06666666666666666667    ; 1/15
        .word 0.05882352941176470588    ; 1/17
        .word 0.5                       ; 1/2!
        .word 1.66666666666666666667e-1 ; 1/3!
        .word 4.16666666666666666667e-2 ; 1/4!
        .word 8.33333333333333333333e-3 ; 1/5!
        .word 1.38888888888888888889e-3 ; 1/6!
        .word 1.98412698412698412698e-4 ; 1/7!
        .word 2.48015873015873015873e-5 ; 1/8!
        .word 2.75573192239858906526e-6 ; 1/9!
        .word 2.75573192239858906526e-7 ; 1/10!
        .word 2.50521083854417187751e-8 ; 1/11!
        .word 2.08767569878680989792e-9 ; 1/12!
        .word 1.60590438368216145994e-10 ; 1/13!
        .code
