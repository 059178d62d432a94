; gloss.s - finishes that depend on the angle, as both forms of the program have
; them (GLOSS = 1).
;
; Of brilliance b diffuse light goes by (N.L)^b.  With x = acos(c) / (pi/2) and
;
;   F(c) = .014567225 / (x - 1.12)^2 - .011612903,  from 0 to 1,
;
; metallic highlights have the light's colour times
;
;   1 + metallic (1 - F(N.L)) (pigment - 1)
;
; What a mirror takes of the reflected ray's colour, seen at the cosine c, is
;
;   least + share (most - least)            share = (1 - c)^falloff or
;       Fresnel's: (p^2 (1 + q^2)) / 2,     g = sqrt(n^2 + c^2 - 1),
;       p = (g - c) / (g + c),  q = (c (g + c) - 1) / (c (g - c) + 1),
;       n = w of interior.s where light passes through something, else ior where
;       the ray enters, 1/ior where not
;
; and of a metallic one 1 + metallic (1 - F(c)) (pigment - 1) times that.  The ray
; weighs by the greatest part of that colour before it is made metallic; with a
; power, by the greatest of all angles.
;
; acos(c) is sqrt(1 - c) times a polynomial of the degree 7, within 2.2e-8.
; Source: POV-Ray 3.7's, measured by its pictures; acos: Abramowitz and Stegun,
; Handbook of Mathematical Functions, 4.4.46, here divided by pi/2.

        .data
gloss_constants:
        .word -8.0372679670e-4, 4.2463112411e-3, -1.0878638630e-2
        .word 1.9666382250e-2, -3.1941954373e-2, 5.6645782704e-2
        .word -1.3661784022e-1, 9.9999998612e-1
        .word 1.12, .014567225
        .word 1.011612903               ; 1 - F = this - ..
        .equ    GLOSS_CONSTANTS, 11
        .code
