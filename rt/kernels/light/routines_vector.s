; routines_vector.s - kernels of light that are written once, as routines of the
; vector form (forms_vector.s).

        .if     FOG
        .kernel resolve
; Applies the fogs (fog.s) to the colours out_red, out_green, out_blue of the n
; rays, which see the distances fog_depth.
fog_rays:
        RTOR    n, h
        call_routine set_hits, link_inner
        .reg    fog_distance, fog_depth
        see_through_fog out_red, out_green, out_blue
        BIM     0, link_kernel
        .endkernel
        .endif

        .if     BUMPS
        .data
        .align  64
bump_normals:   .space 3 * QUEUE        ; normals of a part without bumps
bump_bits:      .space 2 * QUEUE_BIT_WORDS
        .code

        .macro  turn_back before, v
        MPYSV   [v4], [\before], [v6]
        SUBNV   [\v], [v6], [\v] ? [s7]
        .endm

        .kernel spawn
; Corrects reflected directions v1 v2 v3 that would go behind the surface of a
; part with bumps.  Changes v4, v6; called by BSAVE link_kernel.
mirror_outside:
        load_field P_BUMP, s0
        IBXEQ   s0, r0, r0, mirror_is_outside
        normals_before s4, s5, s6
        describe s7, bump_bits, m
        describe s8, bump_bits + 64 * QUEUE_BIT_WORDS, m
        dot_vectors v1, v2, v3, s4, s5, s6, v4, v6
        CMPLTV  [v4], r0, [s7]
        dot_vectors v1, v2, v3, nx, ny, nz, v4, v6
        CMPLTV  [v4], r0, [s8]
        ANDB    [s7], [s8], [s8]
        VTOV    [hdx], [v1] ? [s8]
        VTOV    [hdy], [v2] ? [s8]
        VTOV    [hdz], [v3] ? [s8]
        dot_vectors v1, v2, v3, s4, s5, s6, v4, v6
        MPYSV   [v4], two, [v4]
        turn_back s4, v1
        turn_back s5, v2
        turn_back s6, v3
mirror_is_outside:
        BIM     0, link_kernel

; Changes the sign of the root v7 for rays that see the back of the normal.
refract_from_back:
        describe s7, bump_bits, m
        CMPLTV  r0, [facing], [s7]
        VTOV    -[v7], [v7] ? [s7]
        BIM     0, link_kernel
        .endkernel

        .reg    pattern_link, link_pattern
        .include "light/bump.s"
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
        copy_three spawn_r, spawn_g, spawn_b, [red], [green], [blue], VTOV
        VTOV    spawn_most, [ndotl]
        BIM     0, link_gloss
        .endkernel
        .endif
