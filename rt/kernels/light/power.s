; power.s - computes p_x = p_x ^ exponent for numbers above 0, in both forms.
;
;   x = f 2^k, f in [1/2, 1);  s = (f - sqrt(1/2)) / (f + sqrt(1/2)), |s| < 0.172
;   log2 x = k - 1/2 + 2 artanh s / ln 2
;   z = exponent log2 x, not below -1000
;   2^z = 2^n e^((z - n) ln 2),  n = floor(z + 1/2)
;
; The polynomials are those of asm/lib/series.s.  The error is below
; 2 (1 + |z| + |exponent|) units of the last place.  asm/lib/power.s has less,
; but takes more operations, because its z has double length.
;
; two_to, the second half: p_x = 2^p_x, for numbers not above about 0.
;
; In:  p_x > 0 and not above about 1; exponent.  Out: p_x.  Changes p_k, p_s,
;      p_square; vectors also hits1.
; Source: the method is textbook; the split is derived here for this format.

        .kernel power
power:
        exponent p_x, p_k
        raise_index p_k, p_47, p_k
        normal  p_k, p_k                        ; k
        pack_exponent p_minus_47, p_x, p_x      ; f
        lower   p_x, p_root_half, p_s
        raise   p_x, p_root_half, p_x
        quotient p_s, p_x, p_s                  ; s
        times   p_s, p_s, p_square
        log_polynomial , p_square, p_x
        step    p_square, m_two, p_x
        times   p_x, p_s, p_x
        scaled_plus p_x, p_per_ln2, p_k, p_x
        lowered_scale p_x, m_half, exponent, p_x ; z
two_to:
        not_below_number p_floor, p_x
        raise   p_x, m_half, p_k
        floor   p_k, p_k                        ; n
        normal  p_k, p_s
        difference_scale p_x, p_s, p_ln2, p_s
        exp_of_rest , p_s, p_k, p_x, p_square, p_x
        BIM     0, power_link
        .endkernel
