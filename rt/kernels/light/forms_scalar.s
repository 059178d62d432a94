; forms_scalar.s - kernels of light that are written once, in the scalar form:
; their registers, and the macros that differ from those of forms_vector.s.

; fog.s
        .share  local
        .regs   r32, fog_at, fogs_left, fog_distance
        .regs   r35, fog_scale, fog_least, fog_red, fog_green, fog_blue
        .regs   r40, fog_pass_red, fog_pass_green, fog_pass_blue
        .regs   r43, fog_share, fog_work
        .regs   r45, pass_red, pass_green, pass_blue, haze_red, haze_green
        .reg    haze_blue, r50
        .endshare
