; gloss_scalar.s - computes finishes that depend on the angle at a point.  The
; formulas are in gloss.s.  The order of the operations is that of
; gloss_vector.s and, for find_sheen, of mirror_vector.s.  These macros and
; registers are a part of the subroutines that shade.

        .include "light/gloss.s"

        .share  local
        .regs   r95, f_brilliance, f_metallic
        .regs   r97, g_share, g_cosine, g_work, g_root
        .regs   r101, g_a7, g_a6, g_a5, g_a4, g_a3, g_a2, g_a1, g_a0
        .regs   r109, g_turn, g_scale, g_top
        .endshare
        .equ    GLOSS_REGISTERS, 80     ; up to these

        .macro  gloss_horner c
        MPYS    g_share, g_cosine, g_work
        ADDN    g_work, \c, g_share
        .endm

; g_share = 1 - F(g_share), for a cosine above 0, or with bumps for any cosine.
        .macro  find_sheen
        EX      g_work, gloss_constants
        ELEN    g_work, GLOSS_CONSTANTS
        SWAP    [g_work], g_a7, [r0]
        RTOR    g_share, g_cosine
        .if     BUMPS
        RTOR    g_share, third
        ABS     g_cosine, g_cosine
        .endif
        CFPGE   m_one, g_cosine, sheen_cosine\@
        RTOR    m_one, g_cosine
sheen_cosine\@:
        SUBN    m_one, g_cosine, g_root
        SQRT    g_root, g_root
        MPYS    g_cosine, g_a7, g_work
        ADDN    g_work, g_a6, g_share
        gloss_horner g_a5
        gloss_horner g_a4
        gloss_horner g_a3
        gloss_horner g_a2
        gloss_horner g_a1
        gloss_horner g_a0
        MPYS    g_share, g_root, g_share
        .if     BUMPS
        CFPGE   third, r0, sheen_front\@
        SUBN    m_two, g_share, g_share
sheen_front\@:
        .endif
        SUBN    g_share, g_turn, g_share
        MPYS    g_share, g_share, g_share
        DIVS    g_scale, g_share, g_share
        SUBN    g_top, g_share, g_share
        CFPGE   g_share, r0, sheen_above\@
        RTOR    m_zero, g_share
sheen_above\@:
        CFPGE   m_one, g_share, sheen_below\@
        RTOR    m_one, g_share
sheen_below\@:
        .endm

; t0 = diffuse times (N.L)^brilliance.
        .macro  find_diffuse
        CFPNE   f_brilliance, m_one, diffuse_power\@
        MPYS    ndotl, f_diffuse, t0
        BIM     diffuse_found\@
diffuse_power\@:
        RTOR    ndotl, p_x
        RTOR    f_brilliance, exponent
        EX      target, power
        BSAVE   power_link, [target]
        MPYS    p_x, f_diffuse, t0
diffuse_found\@:
        .endm

; g_share = metallic (1 - F), for the highlights of a metal.
        .macro  find_metal
        CFPEQ   f_metallic, r0, metal_none\@
        RTOR    ndotl, g_share
        find_sheen
        MPYS    g_share, f_metallic, g_share
metal_none\@:
        .endm

; to = 1 + g_share (pigment - 1).
        .macro  metal_colour pigment, to
        SUBN    \pigment, m_one, \to
        MPYS    \to, g_share, \to
        ADDN    \to, m_one, \to
        .endm

        .macro  add_metallic light, pigment, channel
        metal_colour \pigment, t1
        MPYS    t0, t1, t1
        add_light t1, \light, \channel
        .endm

        .macro  add_highlight amount
        MPYS    p_x, \amount, t0
        CFPNE   f_metallic, r0, highlight_metallic\@
        add_light t0, light_r, red
        add_light t0, light_g, green
        add_light t0, light_b, blue
        BIM     highlight_added\@
highlight_metallic\@:
        add_metallic light_r, color0r, red
        add_metallic light_g, color0g, green
        add_metallic light_b, color0b, blue
highlight_added\@:
        .endm
