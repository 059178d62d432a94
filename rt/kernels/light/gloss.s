; gloss.s - the formulas of finishes that depend on the angle, for the scalar
; and the vector form (GLOSS = 1).
;
; With brilliance b diffuse light is proportional to (N.L)^b.  With
; x = acos(c) / (pi/2) and
;
;   F(c) = .014567225 / (x - 1.12)^2 - .011612903,  clamped to 0 .. 1,
;
; metallic highlights have the light's colour multiplied by
;
;   1 + metallic (1 - F(N.L)) (pigment - 1)
;
; A mirror seen at the cosine c multiplies the colour of the reflected ray by
;
;   least + share (most - least)            share = (1 - c)^falloff or
;       Fresnel's: (p^2 (1 + q^2)) / 2,     g = sqrt(n^2 + c^2 - 1),
;       p = (g - c) / (g + c),  q = (c (g + c) - 1) / (c (g - c) + 1),
;       n = w of interior.s if light passes through something, else ior if the
;       ray enters, 1/ior if it leaves
;
; and a metallic one by 1 + metallic (1 - F(c)) (pigment - 1) times that.  The
; weight of the reflected ray is the maximum component of that colour without
; the metallic factor; with a power, it is the maximum over all angles.
;
; acos(c) is sqrt(1 - c) times a polynomial of degree 7, within 2.2e-8.
; Source: POV-Ray 3.7, verified by its pictures; acos: Abramowitz and Stegun,
; Handbook of Mathematical Functions, 4.4.46, here divided by pi/2.

        .data
gloss_constants:
        .word -8.0372679670e-4, 4.2463112411e-3, -1.0878638630e-2
        .word 1.9666382250e-2, -3.1941954373e-2, 5.6645782704e-2
        .word -1.3661784022e-1, 9.9999998612e-1
        .word 1.12, .014567225
        .word 1.011612903               ; 1 - F = this minus the quotient
        .equ    GLOSS_CONSTANTS, 11
        .code
