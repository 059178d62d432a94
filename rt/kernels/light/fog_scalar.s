; fog_scalar.s - applies fogs to one colour.  Formulas and order of the
; operations are those of fog_vector.s.

        .share  local
        .regs   r32, fog_at, fogs_left, fog_distance
        .regs   r35, fog_scale, fog_least, fog_red, fog_green, fog_blue
        .regs   r40, fog_pass_red, fog_pass_green, fog_pass_blue
        .regs   r43, fog_share, fog_work
        .regs   r45, pass_red, pass_green, pass_blue, haze_red, haze_green
        .reg    haze_blue, r50
        .endshare

        .macro  fog_channel fog, fog_pass, pass, haze
        MPYS    p_x, \fog_pass, fog_work
        MPYS    \pass, fog_work, \pass
        MPYS    fog_share, \fog, fog_work
        ADDN    \haze, fog_work, \haze
        .endm

        .macro  fog_blend color, pass, haze
        MPYS    \color, \pass, fog_work
        ADDN    fog_work, \haze, \color
        .endm

; Applies the fogs to the colour, seen at fog_distance.
        .macro  see_through_fog red, green, blue
        EX      fog_scale, scene_fogs
        ELEN    fog_scale, 2
        SWAP    [fog_scale], fog_at, [r0]       ; also fogs_left
        RTOR    m_one, pass_red
        RTOR    m_one, pass_green
        RTOR    m_one, pass_blue
        RTOR    m_zero, haze_red
        RTOR    m_zero, haze_green
        RTOR    m_zero, haze_blue
fog_next\@:
        ELEN    fog_at, FOG_SIZE
        SWAP    [fog_at], fog_scale, [r0]
        MPYS    fog_distance, fog_scale, p_x
        EX      target, two_to
        BSAVE   power_link, [target]
        CFPGE   p_x, fog_least, fog_dimmed\@
        RTOR    fog_least, p_x
fog_dimmed\@:
        SUBN    m_one, p_x, fog_share
        fog_channel fog_red, fog_pass_red, pass_red, haze_red
        fog_channel fog_green, fog_pass_green, pass_green, haze_green
        fog_channel fog_blue, fog_pass_blue, pass_blue, haze_blue
        IX      fog_at, 64 * FOG_SIZE
        IBXNE   fogs_left, m_index_minus_one, r0, fog_next\@, fogs_left
        fog_blend \red, pass_red, haze_red
        fog_blend \green, pass_green, haze_green
        fog_blend \blue, pass_blue, haze_blue
        .endm
