; mirror.s - the colour and weight of a mirror that depends on the angle, in
; both forms (gloss.s).

        .macro  mirror_metallic pigment, channel
        metal_colour g_sheen, \pigment, g_work
        times   \channel, g_work, \channel
        .endm

; Computes the reflection's colour and weight from the cosine -N . D.  Branches
; to mirror_constant if it does not depend on the angle.
        .macro  mirror_by_angle
        load_record P_REFLECTION_RANGE, 6, g_red
        IBXEQ   g_kind, r0, r0, mirror_constant
        negate  sp_facing, g_seen
        IBXNE   g_kind, r0, m_index_one, mirror_fresnel
        from    m_one, g_seen, p_x
        not_below_number m_tiny, p_x
        CFPEQ   g_falloff, m_one, mirror_power
        power_of g_falloff
mirror_power:
        copy    p_x, g_share
        set_mirror_weight
        add_share_of_range
        BIM     mirror_tinted

mirror_fresnel:
        find_mirror_index g_index
        times   g_index, g_index, g_index
        times   g_seen, g_seen, g_g
        plus    g_g, g_index, g_g
        lower   g_g, m_one, g_g
        not_below_number m_zero, g_g            ; total reflection
        root    g_g, g_g
        minus   g_g, g_seen, g_less
        plus    g_g, g_seen, g_more
        quotient g_less, g_more, g_p
        times   g_p, g_p, g_p
        step_lower g_seen, m_one, g_more
        step    g_seen, m_one, g_less
        quotient g_more, g_less, g_less         ; q
        times   g_less, g_less, g_less
        raised_times g_less, m_one, g_p, p_x
        scale   p_x, m_half, p_x
        unless_below_number p_x, m_one, mirror_partial  ; also if indefinite
        otherwise_set m_one, p_x
        end_if  mirror_partial
        copy    p_x, g_share
        add_share_of_range
        copy    sp_red, sp_greatest
        not_below sp_green, sp_greatest
        not_below sp_blue, sp_greatest
        weigh_mirror
mirror_tinted:
        CFPEQ   g_metallic, r0, mirror_found
        load_pigment
        copy    g_seen, g_sheen
        find_sheen
        scale   g_sheen, g_metallic, g_sheen
        mirror_metallic g_pigment_r, sp_red
        mirror_metallic g_pigment_g, sp_green
        mirror_metallic g_pigment_b, sp_blue
mirror_found:
        .endm
