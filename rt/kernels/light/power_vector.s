; power_vector.s - computes [v0] = [v0] ^ exponent for m numbers above 0.
;
;   x = c 2^e = f 2^k, f in [1/2, 1);  log2 x = k - 1/2 + log2(f / sqrt(1/2))
;   with s = (f - sqrt(1/2)) / (f + sqrt(1/2)), |s| < 0.172,
;   log2(f / sqrt(1/2)) = 2/ln 2 (s + s^3/3 + s^5/5 + ... + s^17/17)
;   z = exponent log2 x, not below -1000
;   2^z = 2^floor(z) sqrt(2) e^((z - floor(z) - 1/2) ln 2), the exponential
;   by its series up to the 13th power; |argument| < 0.347.
;
; The first omitted terms are 2e-15 and 4e-18; the truncation to 47 bits is
; larger.  f is formed by writing the exponent -47 over that of x, and 2^k by
; writing k - 46 above the coefficient 2^46: shift and logical instructions
; operate on this machine's floats.
;
; two_to, the second half: [v0] = 2^[v0], for numbers not above about 0.
;
; In:  [v0] > 0 and not above about 1; exponent; m.  Out: [v0].
; Changes v1-v4, hits1, s0.
; Source: the series are textbook; the split is derived here for this format.

; horner: [v0] = [v0] x + c.  horner_start: the first such step.
        .macro  horner x, c
        LINKV
        MPYSV   [v0], [\x], [v4]
        ADDNV   [v4], \c, [v0]
        .endm

        .macro  horner_start x, top, c
        LINKV
        MPYSV   [\x], \top, [v4]
        ADDNV   [v4], \c, [v0]
        .endm

; [v0] := [v0] ^ exponent where [v0] is above 0, else 0.  Also changes hits0,
; s2.
        .macro  power_of_positive
        CMPLTV  r0, [v0], [hits0]
        MASKV   [v0], one, [v0] ? [hits0]
        EX      target, power
        BSAVE   link_inner, [target]
        ADDN    r0, r0, s2
        MASKV   [v0], s2, [v0] ? [hits0]
        .endm

        .kernel power
power:
        EXPV    [v0], [v1]
        ADDUV   [v1], p_47, [v1]
        ADDNV   [v1], r0, [v1]          ; k
        ANDV    [v0], p_fraction, [v0]
        ORV     [v0], p_scale, [v0]     ; f
        SUBNV   [v0], p_root_half, [v2]
        ADDNV   [v0], p_root_half, [v0]
        DIVSV   [v2], [v0], [v2]        ; s
        MPYSV   [v2], [v2], [v3]
        log_series v3, one
        MPYSV   [v0], [v2], [v0]
        LINKV
        MPYSV   [v0], p_two_over_ln2, [v4]
        ADDNV   [v4], [v1], [v0]
        LINKV
        SUBNV   [v0], half, [v0]        ; log2 x
        MPYSV   [v0], exponent, [v0]
two_to:
        CMPLTV  [v0], p_floor, [hits1]
        VTOV    p_floor, [v0] ? [hits1] ; z
        FLRV    [v0], [v1]
        ADDNV   [v1], r0, [v2]
        SUBNV   [v0], [v2], [v2]
        LINKV
        SUBNV   [v2], half, [v2]
        MPYSV   [v2], p_ln2, [v2]
        horner_start v2, exp13, exp12
        horner v2, exp11
        horner v2, exp10
        horner v2, exp9
        horner v2, exp8
        horner v2, exp7
        horner v2, exp6
        horner v2, exp5
        horner v2, exp4
        horner v2, exp3
        horner v2, exp2
        horner v2, one
        horner v2, one
        MPYSV   [v0], p_root_two, [v0]
        LINKV
        ADDUV   [v1], p_minus_46, [v1]
        SHIFTV  [v1], p_48, [v1]
        ANDV    [v1], p_upper, [v1]
        ORV     [v1], p_unit, [v1]      ; 2^floor(z)
        MPYSV   [v0], [v1], [v0]
        BIM     0, link_inner
        .endkernel
