; fog_vector.s - applies fogs to the colours of n rays (fog.s).
;
; In:  n; fog_depth: the distances they see; out_red, out_green, out_blue:
;      colours.
; Out: these colours, dimmed and with the haze of the fogs.
; Source: fog.s.

        .share  scratch
        .regs   r233, fog_at, fogs_left
        .regs   r235, fog_scale, fog_least, fog_red, fog_green, fog_blue
        .regs   r240, fog_pass_red, fog_pass_green, fog_pass_blue
        .endshare

; [red] .. = the product of the transmitted shares, [cr] .. = the sum of the
; haze; [v0] = a.
        .macro  fog_channel fog, fog_pass, pass, haze
        MPYSV   [v0], \fog_pass, [v6]
        MPYSV   [\pass], [v6], [\pass]
        LINKV
        MPYSV   [v5], \fog, [v6]
        ADDNV   [\haze], [v6], [\haze]
        .endm

        .macro  fog_blend color, pass, haze
        MPYSV   [\color], [\pass], [v6]
        ADDNV   [v6], [\haze], [\color]
        .endm

        .kernel resolve
fog_rays:
        RTOR    n, h
        EX      target, set_hits
        BSAVE   link_inner, [target]
        VTOV    one, [red]
        VTOV    one, [green]
        VTOV    one, [blue]
        VTOV    r0, [cr]
        VTOV    r0, [cg]
        VTOV    r0, [cb]
        EX      fog_scale, scene_fogs
        ELEN    fog_scale, 2
        SWAP    [fog_scale], fog_at, [r0]       ; also fogs_left
fog_next:
        ELEN    fog_at, FOG_SIZE
        SWAP    [fog_at], fog_scale, [r0]
        MPYSV   [fog_depth], fog_scale, [v0]
        EX      target, two_to
        BSAVE   link_inner, [target]
        CMPLTV  [v0], fog_least, [hits1]
        VTOV    fog_least, [v0] ? [hits1]
        SUBNV   one, [v0], [v5]
        fog_channel fog_red, fog_pass_red, red, cr
        fog_channel fog_green, fog_pass_green, green, cg
        fog_channel fog_blue, fog_pass_blue, blue, cb
        IX      fog_at, 64 * FOG_SIZE
        IBXNE   fogs_left, minus_one_index, r0, fog_next, fogs_left
        fog_blend out_red, red, cr
        fog_blend out_green, green, cg
        fog_blend out_blue, blue, cb
        BIM     0, link_kernel
        .endkernel
