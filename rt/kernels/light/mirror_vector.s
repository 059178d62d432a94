; mirror_vector.s - computes the share of a metal's own colour at an angle, and
; the colours of mirrors that depend on the angle.  The formulas are in gloss.s.

; [v0] = 1 - F([v0]), for cosines above 0, or with bumps for any.  Changes
; v1-v4, hits1, s0, s1.
        .kernel shade
find_sheen:
        EX      s0, gloss_constants
        ELEN    s0, GLOSS_CONSTANTS
        SWAP    [s0], m00, [r0]
        .if     BUMPS
        VTOV    [v0], [v3]
        ABSV    [v0], [v0]
        .endif
        CMPLTV  one, [v0], [hits1]
        VTOV    one, [v0] ? [hits1]
        VTOV    [v0], [v2]
        SUBNV   one, [v2], [v1]
        SQRTV   [v1], [v1]
        horner_start v2, m00, m01
        horner  v2, m02
        horner  v2, m03
        horner  v2, m10
        horner  v2, m11
        horner  v2, m12
        horner  v2, m13
        .if     BUMPS
        MPYSV   [v0], [v1], [v0]
        SUBNV   two, [v0], [v1]
        CMPLTV  [v3], r0, [hits1]
        VTOV    [v1], [v0] ? [hits1]    ; x
        .else
        LINKV
        MPYSV   [v0], [v1], [v0]        ; x
        .endif
        SUBNV   [v0], m20, [v0]
        MPYSV   [v0], [v0], [v0]
        DIVSV   m21, [v0], [v0]
        SUBNV   m22, [v0], [v0]
        CMPLTV  [v0], r0, [hits1]
        VTOV    r0, [v0] ? [hits1]
        CMPLTV  one, [v0], [hits1]
        VTOV    one, [v0] ? [hits1]
        BIM     0, link_inner
        .endkernel

        .macro  mirror_channel range, least, channel
        LINKV
        MPYSV   [v6], \range, [\channel]
        ADDNV   [\channel], \least, [\channel]
        .endm

        .macro  mirror_colours
        mirror_channel sh0, spawn_r, red
        mirror_channel sh1, spawn_g, green
        mirror_channel sh2, spawn_b, blue
        .endm

        .macro  mirror_metallic pigment, channel
        metal_colour v0, \pigment
        MPYSV   [\channel], [v1], [\channel]
        .endm

        .macro  greatest channel
        CMPLTV  [ndotl], [\channel], [hits1]
        VTOV    [\channel], [ndotl] ? [hits1]
        .endm

; Computes the colours of a mirror, which may depend on the angle, in red,
; green, blue, and the weights of the rays in ndotl.
;
; In:  cr cg cb, facing, hits0; spawn_index, spawn_r ..
; Changes v0-v6, hits1, hits2.
        .kernel spawn
find_mirror:
        RTOR    link_kernel, link_gloss
        load_record P_REFLECTION_RANGE, 6, sh0
        IBXEQ   sh5, r0, r0, mirror_constant
        VTOV    -[facing], [v5]
        IBXNE   sh5, r0, one_index, mirror_fresnel
        SUBNV   one, [v5], [v0]
        CMPLTV  [v0], tiny, [hits1]
        VTOV    tiny, [v0] ? [hits1]
        CFPEQ   sh3, one, mirror_power
        RTOR    sh3, exponent
        EX      target, power
        BSAVE   link_inner, [target]
mirror_power:
        VTOV    [v0], [v6]
        VTOV    spawn_most, [ndotl]
        mirror_colours
        BIM     mirror_tinted

mirror_fresnel:
        .if     INTERIORS
        VTOV    [v7], [v1]
        .else
        find_entering
        MASKV   spawn_index, spawn_reciprocal, [v1] ? [hits2]
        .endif
        MPYSV   [v1], [v1], [v1]
        MPYSV   [v5], [v5], [v2]
        ADDNV   [v2], [v1], [v1]
        SUBNV   [v1], one, [v1]
        CMPLTV  [v1], r0, [hits1]
        VTOV    r0, [v1] ? [hits1]      ; total reflection
        SQRTV   [v1], [v1]              ; g
        SUBNV   [v1], [v5], [v2]
        ADDNV   [v1], [v5], [v3]
        DIVSV   [v2], [v3], [v4]        ; p
        MPYSV   [v4], [v4], [v4]
        LINKV
        MPYSV   [v5], [v3], [v3]
        SUBNV   [v3], one, [v3]
        LINKV
        MPYSV   [v5], [v2], [v2]
        ADDNV   [v2], one, [v2]
        DIVSV   [v3], [v2], [v2]        ; q
        MPYSV   [v2], [v2], [v2]
        LINKV
        ADDNV   [v2], one, [v2]
        MPYSV   [v2], [v4], [v0]
        MPYSV   [v0], half, [v0]
        CMPLTV  [v0], one, [hits1]
        VTOV    one, [v0] ?! [hits1]    ; also if indefinite
        VTOV    [v0], [v6]
        mirror_colours
        VTOV    [red], [ndotl]
        greatest green
        greatest blue
mirror_tinted:
        CFPEQ   sh4, r0, mirror_found
        VTOV    [v5], [v0]
        EX      target, find_sheen
        BSAVE   link_inner, [target]
        MPYSV   [v0], sh4, [v0]
        mirror_metallic cr, red
        mirror_metallic cg, green
        mirror_metallic cb, blue
mirror_found:
        BIM     0, link_gloss

mirror_constant:
        VTOV    spawn_r, [red]
        VTOV    spawn_g, [green]
        VTOV    spawn_b, [blue]
        VTOV    spawn_most, [ndotl]
        BIM     0, link_gloss
        .endkernel
