; circle.s - a point of the unit circle: sine and cosine of 2 pi u, u in (0, 1).
;
; With v = 1/2 - u, in (-1/2, 1/2), the two Taylor polynomials in v^2
;
;   s = sin pi v = v (pi - pi^3/3! v^2 + .. - pi^19/19! v^18)
;   c = cos pi v = 1 - pi^2/2! v^2 + .. - pi^18/18! v^18
;
; have errors below 4e-15, and
;
;   sin 2 pi u = 2 s c,   cos 2 pi u = 2 s^2 - 1.
;
; There is no case distinction. Including truncation, the errors of both and of
; the point's length are below 3e-13.
;
; In:  turn, a column.
; Out: sine, cosine, columns.
; Source: textbook. The half angle makes a choice of quadrants unnecessary.

        .data
circle_constants:
        .word   0.5, 1.0, -1.0
        .word   3.1415926535897932384626, -5.1677127800499700292460
        .word   2.5501640398773454438562, -0.5992645293207920768877
        .word   0.0821458866111282287988, -0.0073704309457143507773
        .word   0.0004663028057676125644, -0.0000219153534478302158
        .word   0.0000007952054001475513, -0.0000000229484289972699
        .word   1.0, -4.9348022005446793094172
        .word   4.0587121264167682181850, -1.3352627688545894958753
        .word   0.2353306303588932045419, -0.0258068913900140600126
        .word   0.0019295743094039230479, -0.0001046381049248457071
        .word   0.0000043030695870329470, -0.0000001387895246221377
        .equ    CIRCLE_CONSTANTS, 23
        .code

        .regs   r67, half, one, minus_one
        .regs   r70, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6, sine_7, sine_8, sine_9
        .regs   r80, cosine_0, cosine_1, cosine_2, cosine_3, cosine_4, cosine_5, cosine_6, cosine_7, cosine_8, cosine_9

        .macro  circle_load scratch
        EX      \scratch, circle_constants
        ELEN    \scratch, CIRCLE_CONSTANTS
        SWAP    [\scratch], half, [r0]
        .endm

        .macro  circle_step even, odd, sine, cosine, odd_sine, odd_cosine, fourth
        step_four \fourth, \sine, sine_\even, \odd_sine, sine_\odd, \cosine, cosine_\even, \odd_cosine, cosine_\odd
        .endm

; Splits both polynomials into those of even and odd powers of v^2, which are
; polynomials in v^4. work0 .. work4 are scratch.
        .macro  circle turn, sine, cosine, work0, work1, work2, work3, work4
        from    half, \turn, \work0             ; v
        times   \work0, \work0, \work1          ; v^2
        times   \work1, \work1, \work2
        scale   \work2, sine_8, \sine
        scale   \work2, sine_9, \work3
        scale   \work2, cosine_8, \cosine
        scale   \work2, cosine_9, \work4
        raise   \sine, sine_6, \sine
        raise   \work3, sine_7, \work3
        raise   \cosine, cosine_6, \cosine
        raise   \work4, cosine_7, \work4
        circle_step 4, 5, \sine, \cosine, \work3, \work4, \work2
        circle_step 2, 3, \sine, \cosine, \work3, \work4, \work2
        circle_step 0, 1, \sine, \cosine, \work3, \work4, \work2
        times   \work3, \work1, \work3
        times   \work4, \work1, \work4
        plus    \sine, \work3, \sine
        plus    \cosine, \work4, \cosine        ; c
        times   \work0, \sine, \work0           ; s
        plus    \work0, \work0, \work1
        times   \work1, \cosine, \sine
        times   \work1, \work0, \cosine
        raise   \cosine, minus_one, \cosine
        .endm
