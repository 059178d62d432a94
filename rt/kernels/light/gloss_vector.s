; gloss_vector.s - computes finishes that depend on the angle at a part of the
; hits.  The formulas are in gloss.s.  These macros are a part of the routines
; that shade.

        .include "light/gloss.s"

        .share  scratch
        .regs   r248, f_brilliance, f_metallic
        .reg    link_gloss, r250
        .endshare

; [v0] = diffuse times (N.L)^brilliance.
        .macro  find_diffuse
        CFPNE   f_brilliance, one, diffuse_power\@
        MPYSV   [ndotl], f_diffuse, [v0]
        BIM     diffuse_found\@
diffuse_power\@:
        MASKV   [ndotl], one, [v0] ? [hits3]
        RTOR    f_brilliance, exponent
        EX      target, power
        BSAVE   link_inner, [target]
        MPYSV   [v0], f_diffuse, [v0]
diffuse_found\@:
        .endm

; [v7] = metallic (1 - F), for the highlights of a metal.
        .macro  find_metal
        CFPEQ   f_metallic, r0, metal_none\@
        MASKV   [ndotl], one, [v0] ? [hits3]
        EX      target, find_sheen
        BSAVE   link_inner, [target]
        MPYSV   [v0], f_metallic, [v7]
metal_none\@:
        .endm

; [v1] = 1 + [sheen] (pigment - 1).
        .macro  metal_colour sheen, pigment
        LINKV
        SUBNV   [\pigment], one, [v1]
        MPYSV   [v1], [\sheen], [v1]
        ADDNV   [v1], one, [v1]
        .endm

        .macro  add_metallic light, pigment, channel
        metal_colour v7, \pigment
        MPYSV   [v0], [v1], [v1]
        add_light v1, \light, \channel, hits0
        .endm

        .macro  add_highlight amount, light_r, light_g, light_b
        MPYSV   [v0], \amount, [v0]
        CFPNE   f_metallic, r0, highlight_metallic\@
        add_light v0, \light_r, red, hits0
        add_light v0, \light_g, green, hits0
        add_light v0, \light_b, blue, hits0
        BIM     highlight_added\@
highlight_metallic\@:
        add_metallic \light_r, cr, red
        add_metallic \light_g, cg, green
        add_metallic \light_b, cb, blue
highlight_added\@:
        .endm
