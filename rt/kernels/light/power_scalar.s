; power_scalar.s - computes p_x = p_x ^ exponent; two_to: p_x = 2^p_x.  Method,
; series and order of the operations are those of power_vector.s.  This is a
; fast library routine:  its arguments and constants are in registers, and BSAVE
; power_link calls it.

        .regs   r233, p_x, p_k, p_s, p_square, p_t, power_link

        .macro  horner x, c
        MPYS    p_x, \x, p_t
        ADDN    p_t, \c, p_x
        .endm

        .macro  horner_start x, top, c
        MPYS    \x, \top, p_t
        ADDN    p_t, \c, p_x
        .endm

; p_x := p_x ^ exponent if p_x is above 0, else 0.
        .macro  power_of_positive
        CFPGE   r0, p_x, power_dark\@
        EX      target, power
        BSAVE   power_link, [target]
        BIM     power_done\@
power_dark\@:
        RTOR    m_zero, p_x
power_done\@:
        .endm

        .kernel power
power:
        EXP     p_x, p_k
        ADDU    p_k, p_47, p_k
        ADDN    p_k, r0, p_k            ; k
        AND     p_x, p_fraction, p_x
        OR      p_x, p_scale, p_x       ; f
        SUBN    p_x, p_root_half, p_s
        ADDN    p_x, p_root_half, p_x
        DIVS    p_s, p_x, p_s           ; s
        MPYS    p_s, p_s, p_square
        log_series p_square, m_one
        MPYS    p_x, p_s, p_x
        MPYS    p_x, p_two_over_ln2, p_t
        ADDN    p_t, p_k, p_x
        SUBN    p_x, m_half, p_x        ; log2 x
        MPYS    p_x, exponent, p_x
two_to:
        CFPGE   p_x, p_floor, power_in_range
        RTOR    p_floor, p_x            ; z
power_in_range:
        FLR     p_x, p_k
        ADDN    p_k, r0, p_s
        SUBN    p_x, p_s, p_s
        SUBN    p_s, m_half, p_s
        MPYS    p_s, p_ln2, p_s
        horner_start p_s, exp13, exp12
        horner  p_s, exp11
        horner  p_s, exp10
        horner  p_s, exp9
        horner  p_s, exp8
        horner  p_s, exp7
        horner  p_s, exp6
        horner  p_s, exp5
        horner  p_s, exp4
        horner  p_s, exp3
        horner  p_s, exp2
        horner  p_s, m_one
        horner  p_s, m_one
        MPYS    p_x, p_root_two, p_x
        ADDU    p_k, p_minus_46, p_k
        SHIFT   p_k, p_48, p_k
        AND     p_k, p_upper, p_k
        OR      p_k, p_unit, p_k        ; 2^floor(z)
        MPYS    p_x, p_k, p_x
        BIM     0, power_link
        .endkernel
