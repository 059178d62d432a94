; circle.s - a point of the unit circle: sine and cosine of 2 pi u, u in (0, 1).
;
; With v = 1/2 - u, in (-1/2, 1/2), s = sin pi v and c = sin pi (1/2 - |v|),
; by the polynomial of asm/lib/series.s:
;
;   sin 2 pi u = 2 s c,   cos 2 pi u = 2 s^2 - 1.
;
; There is no case distinction. Including truncation, the errors of both and of
; the point's length are below 2e-13.
;
; In:  turn, a column.
; Out: sine, cosine, columns.
; Source: textbook. The half angle makes a choice of quadrants unnecessary.

        .include "series.s"

        .data
circle_constants:
        .word   0.5, 1.0, -1.0
        .word   3.1415926535897932384626, 1.5707963267948966192313
        sine_coefficients
        .equ    CIRCLE_CONSTANTS, 12
        .code

        .regs   r67, half, one, minus_one, half_turn, quarter_turn
        .regs   r72, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6

        .macro  circle_load scratch
        load_words circle_constants, CIRCLE_CONSTANTS, half, \scratch
        .endm

; work, temp0-temp4, temp7, temp8 are scratch.
        .macro  circle turn, sine, cosine, work
        from    half, \turn, temp0              ; v
        scale   temp0, half_turn, temp0
        absolute temp0, temp1
        from    quarter_turn, temp1, temp1
        times   temp0, temp0, temp2
        times   temp1, temp1, temp3
        sine_polynomials , temp2, \sine, temp4, temp7, temp3, \cosine, temp8, \work
        times   temp2, temp0, temp2
        times   temp3, temp1, temp3
        times   \sine, temp2, \sine
        times   \cosine, temp3, \cosine
        plus    \sine, temp0, temp0            ; s
        plus    \cosine, temp1, temp1          ; c
        plus    temp0, temp0, temp2
        times   temp2, temp1, \sine
        times   temp2, temp0, \cosine
        raise   \cosine, minus_one, \cosine
        .endm
