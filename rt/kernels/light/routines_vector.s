; routines_vector.s - kernels of light that are written once, as routines of the
; vector form (forms_vector.s).

        .if     FOG
        .kernel resolve
; Applies the fogs (fog.s) to the colours out_red, out_green, out_blue of the n
; rays, which see the distances fog_depth.
fog_rays:
        RTOR    n, h
        EX      target, set_hits
        BSAVE   link_inner, [target]
        .reg    fog_distance, fog_depth
        see_through_fog out_red, out_green, out_blue
        BIM     0, link_kernel
        .endkernel
        .endif

        .if     GLOSS
        .reg    sp_greatest, ndotl
        .include "light/mirror.s"
        .kernel shade
; [v0] = 1 - F([v0]).
find_sheen:
        compute_sheen
        BIM     0, link_inner
        .endkernel

        .kernel spawn
; Computes the colours of a mirror in red, green, blue, and the weights of the
; rays in ndotl.
;
; In:  cr cg cb, facing, hits0; spawn_index, spawn_r ..
; Changes v0-v6, hits1, hits2.
find_mirror:
        RTOR    link_kernel, link_gloss
        mirror_by_angle
        BIM     0, link_gloss
mirror_constant:
        VTOV    spawn_r, [red]
        VTOV    spawn_g, [green]
        VTOV    spawn_b, [blue]
        VTOV    spawn_most, [ndotl]
        BIM     0, link_gloss
        .endkernel
        .endif
