; gloss.s - finishes that depend on the angle, in both forms (GLOSS = 1).
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

; g_sheen = 1 - F(g_sheen), for a cosine above 0, or with bumps for any cosine.
; Changes g_cosine, g_root, g_signed, g_a7 ...
        .macro  compute_sheen
        load_words gloss_constants, GLOSS_CONSTANTS, g_a7, g_at
        .if     BUMPS
        copy    g_sheen, g_signed
        absolute g_sheen, g_sheen
        .endif
        not_above_number m_one, g_sheen
        copy    g_sheen, g_cosine
        from    m_one, g_cosine, g_root
        root    g_root, g_root
        line    g_cosine, g_a7, g_a6, g_sheen
        step    g_cosine, g_a5, g_sheen
        step    g_cosine, g_a4, g_sheen
        step    g_cosine, g_a3, g_sheen
        step    g_cosine, g_a2, g_sheen
        step    g_cosine, g_a1, g_sheen
        step    g_cosine, g_a0, g_sheen
        .if     BUMPS
        times   g_sheen, g_root, g_sheen
        from    m_two, g_sheen, g_root
        if_less_number g_signed, r0, sheen_front\@
        then_copy g_root, g_sheen
        end_if  sheen_front\@
        lower   g_sheen, g_turn, g_sheen
        .else
        step_lower g_root, g_turn, g_sheen
        .endif
        times   g_sheen, g_sheen, g_sheen
        into    g_scale, g_sheen, g_sheen
        from    g_top, g_sheen, g_sheen
        not_below_number m_zero, g_sheen
        not_above_number m_one, g_sheen
        .endm

; t0 = diffuse times (N.L)^brilliance.
        .macro  find_diffuse
        CFPNE   f_brilliance, m_one, diffuse_power\@
        scale   ndotl, f_diffuse, t0
        BIM     diffuse_found\@
diffuse_power\@:
        copy_lit ndotl, p_x
        power_of f_brilliance
        scale   p_x, f_diffuse, t0
diffuse_found\@:
        .endm

; g_metal = metallic (1 - F), for the highlights of a metal.
        .macro  find_metal
        CFPEQ   f_metallic, r0, metal_none\@
        copy_lit ndotl, g_sheen
        find_sheen
        scale   g_sheen, f_metallic, g_metal
metal_none\@:
        .endm

; to = 1 + sheen (pigment - 1).
        .macro  metal_colour sheen, pigment, to
        lowered_times \pigment, m_one, \sheen, \to
        raise   \to, m_one, \to
        .endm

        .macro  add_metallic light, pigment, channel
        metal_colour g_metal, \pigment, t1
        times   t0, t1, t1
        add_light t1, \light, \channel
        .endm

        .macro  add_highlight amount, light_r, light_g, light_b
        scale   p_x, \amount, t0
        CFPNE   f_metallic, r0, highlight_metallic\@
        three_by add_light, t0, \light_r, \light_g, \light_b, red, green, blue
        BIM     highlight_added\@
highlight_metallic\@:
        three   add_metallic, \light_r, \light_g, \light_b, cr, cg, cb, red, green, blue
highlight_added\@:
        .endm
