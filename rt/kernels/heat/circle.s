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
        .word   3.1415926535897932384626
        sine_coefficients
        .equ    CIRCLE_CONSTANTS, 11
        .code

        .regs   r67, half, one, minus_one, half_turn
        .regs   r71, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6

        .macro  circle_load scratch
        EX      \scratch, circle_constants
        ELEN    \scratch, CIRCLE_CONSTANTS
        SWAP    [\scratch], half, [r0]
        .endm

; work0 .. work3 are scratch.
        .macro  circle turn, sine, cosine, work0, work1, work2, work3
        from    half, \turn, \work0             ; v
        absolute \work0, \work1
        from    half, \work1, \work1
        scale   \work0, half_turn, \work0
        scale   \work1, half_turn, \work1
        times   \work0, \work0, \work2
        times   \work1, \work1, \work3
        sine_polynomials , \work2, \sine, \work3, \cosine
        times   \sine, \work2, \sine
        times   \cosine, \work3, \cosine
        times   \sine, \work0, \sine
        times   \cosine, \work1, \cosine
        plus    \sine, \work0, \work0           ; s
        plus    \cosine, \work1, \work1         ; c
        plus    \work0, \work0, \work2
        times   \work2, \work1, \sine
        times   \work2, \work0, \cosine
        raise   \cosine, minus_one, \cosine
        .endm
