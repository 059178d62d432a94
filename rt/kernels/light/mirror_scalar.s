; mirror_scalar.s - computes the colour of a mirror that depends on the angle.
; The formulas are in gloss.s, the order of the operations is that of
; mirror_vector.s.  These macros are a part of SPAWN (spawn_scalar.s).

        .share  local
        .regs   r112, g_red, g_green, g_blue, g_falloff, g_metallic, g_kind
        .regs   r118, g_pigment, g_pigment_r, g_pigment_g, g_pigment_b
        .regs   r122, g_g, g_less, g_more, g_p
        .endshare
        .equ    MIRROR_REGISTERS, 94    ; up to these

        .macro  mirror_channel range, least
        MPYS    g_share, \range, g_work
        ADDN    g_work, \least, \least
        .endm

        .macro  mirror_metallic pigment, channel
        metal_colour \pigment, g_work
        MPYS    \channel, g_work, \channel
        .endm

        .macro  greatest channel
        CFPGE   sp_greatest, \channel, greatest_found\@
        RTOR    \channel, sp_greatest
greatest_found\@:
        .endm

; Computes the reflection's colour and weight; sp_red .. = the least colour
; before.
        .macro  find_mirror
        RTOR    sp_primitive, sp_at
        IX      sp_at, 64 * P_REFLECTION_RANGE
        ELEN    sp_at, 6
        SWAP    [sp_at], g_red, [r0]
        SUBN    r0, sp_facing, sp_t0            ; c
        IBXEQ   g_kind, r0, r0, mirror_found
        IBXNE   g_kind, r0, m_index_one, mirror_fresnel
        SUBN    m_one, sp_t0, g_share
        CFPGE   g_share, m_tiny, mirror_falls
        RTOR    m_tiny, g_share
mirror_falls:
        CFPEQ   g_falloff, m_one, mirror_share
        RTOR    g_share, p_x
        RTOR    g_falloff, exponent
        EX      target, power
        BSAVE   power_link, [target]
        RTOR    p_x, g_share
        BIM     mirror_share

mirror_fresnel:
        .if     INTERIORS
        RTOR    in_mirror, g_work
        .else
        RTOR    sp_index, g_work
        ES      sp_flag, 0
        CFPGE   sp_outward, r0, mirror_side
        ES      sp_flag, 1
mirror_side:
        IBXNE   sp_flag, r0, sp_inverted, mirror_enters
        RTOR    sp_reciprocal, g_work
mirror_enters:
        .endif
        MPYS    g_work, g_work, g_work
        MPYS    sp_t0, sp_t0, g_g
        ADDN    g_g, g_work, g_g
        SUBN    g_g, m_one, g_g
        CFPGE   g_g, r0, mirror_root
        RTOR    m_zero, g_g                     ; total reflection
mirror_root:
        SQRT    g_g, g_g
        SUBN    g_g, sp_t0, g_less
        ADDN    g_g, sp_t0, g_more
        DIVS    g_less, g_more, g_p
        MPYS    g_p, g_p, g_p
        MPYS    sp_t0, g_more, g_more
        SUBN    g_more, m_one, g_more
        MPYS    sp_t0, g_less, g_less
        ADDN    g_less, m_one, g_less
        DIVS    g_more, g_less, g_less          ; q
        MPYS    g_less, g_less, g_less
        ADDN    g_less, m_one, g_less
        MPYS    g_less, g_p, g_share
        MPYS    g_share, m_half, g_share
        CFPLT   g_share, m_one, mirror_share
        RTOR    m_one, g_share                  ; also if indefinite
mirror_share:
        mirror_channel g_red, sp_red
        mirror_channel g_green, sp_green
        mirror_channel g_blue, sp_blue
        IBXEQ   g_kind, r0, m_index_one, mirror_weighed
        RTOR    sp_red, sp_greatest
        greatest sp_green
        greatest sp_blue
        MPYS    sp_own_weight, sp_greatest, sp_weight
mirror_weighed:
        CFPEQ   g_metallic, r0, mirror_found
        ELEN    g_pigment, 3
        SWAP    [g_pigment], g_pigment_r, [r0]
        RTOR    sp_t0, g_share
        find_sheen
        MPYS    g_share, g_metallic, g_share
        mirror_metallic g_pigment_r, sp_red
        mirror_metallic g_pigment_g, sp_green
        mirror_metallic g_pigment_b, sp_blue
mirror_found:
        .endm
