; scaling.s - scales polynomials with coefficients of any size for the root
; solver.  This macro is a part of roots.s.
;
; With t = 2^k x and a common factor the coefficients become
;
;   d_i = c_i 2^(k i - s),     k = floor((e_0 - e_p) / p),  s = e_p + k p
;
; where p is the degree and e_i the exponent of c_i.  The first and the last
; coefficient get one size, d_p in [1, 2) and d_0 in [1, 16).  Only exponents
; change, so nothing is lost.  With 2^M the size of the largest, all roots are
; in
;
;   2^-(M+2) < |x| < 2^(M+2)        (Cauchy)
;
; A trailing zero is a root at 0.  All of them are removed first, by moving the
; coefficients down.  A coefficient less than 2^-20000 d_p becomes 0.  A
; polynomial is rejected if M > 6900 or if a root might exceed the machine's
; range.
;
; In:  d4 .. d0 and bound.
; Out: d4 .. d0, x_low = the bound / 2^k, size = 2^k, far = 2^(M+2),
;      near = 2^-(M+2); at_zero: 0 is a root above the bound; refused.
; Changes e0-e4, top, degree, k, largest, t0, t1, s0.

        .macro  find_exponent i
        exponent d\i, e\i
        normal  e\i, e\i
        find_present d\i, present\i
        .endm

; e_i := the new exponent, relative to that of d_p.
        .macro  shift_exponent i, power
        if_present d\i, shift_exponent\@
        scaled_plus k, \power, e\i, e\i
        minus   e\i, top, e\i
        not_below_in present\i, e\i, largest
shift_exponent\@:
        .endm

; t0 = the exponent of the word whose coefficient of 47 bits is of size 2^e.
        .macro  word_exponent e
        lower   \e, forty_six, t0
        floor   t0, t0
        .endm

        .macro  scale_coefficient i
        if_present d\i, scale_coefficient\@
        word_exponent e\i
        pack_each t0, d\i, d\i
        clear_less_in present\i, e\i, least_exponent, d\i
scale_coefficient\@:
        .endm

        .macro  scale_polynomials
        remove_zeros
        .rept   5
        find_exponent \+
        .endr
        copy    e0, top
        set     one, degree
        find_top d1, present1, e1, one
        find_top d2, present2, e2, two
        find_top d3, present3, e3, three
        find_top d4, present4, e4, four
        minus   e0, top, t0
        quotient_floor t0, degree, t0
        normal  t0, k
        times   k, degree, t0
        plus    top, t0, top

        clear   largest
        minus   e0, top, e0
        not_below e0, largest
        shift_exponent 1, one
        shift_exponent 2, two
        shift_exponent 3, three
        shift_exponent 4, four
        find_refused

        .rept   5
        scale_coefficient \+
        .endr
        word_exponent k
        pack_coefficient t0, unit, size
        raise   largest, two, t1
        word_exponent t1
        pack_coefficient t0, unit, far
        negate  t1, t1
        word_exponent t1
        pack_coefficient t0, unit, near

        begin_bound scale_bounded       ; the bound's exponent minus k, clamped
        exponent bound, t1
        normal  t1, t1
        minus   t1, k, t1
        not_above_number most_exponent, t1
        SUBN    r0, most_exponent, s0
        not_below_number s0, t1
        floor   t1, t1
        pack_each t1, bound, x_low
scale_bounded:
        end_bound
        .endm
