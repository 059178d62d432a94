; forms_vector.s - kernels of light that are written once, in the vector form:
; their registers, which have the names of the scalar form, and the macros that
; differ from those of forms_scalar.s.

        .share  light
        .reg    here, s0
        .reg    p_x, v0
        .reg    power_link, link_inner
        .reg    m_index_minus_one, minus_one_index
        .endshare

; fog.s
        .share  scratch
        .regs   r233, fog_at, fogs_left
        .regs   r235, fog_scale, fog_least, fog_red, fog_green, fog_blue
        .regs   r240, fog_pass_red, fog_pass_green, fog_pass_blue
        .endshare
        .share  light
        .regs   v5, fog_share, fog_work
        .regs   red, pass_red, pass_green, pass_blue
        .regs   cr, haze_red, haze_green, haze_blue
        .endshare
