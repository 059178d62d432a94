; beam_vector.s - computes the light of beams and fading lights at the hits of a
; queue.  The formulas are in beam.s.

        .include "light/beam.s"

        .share  scratch
        .reg    light_beam, r248        ; after the light's other words
        .endshare
        .share  shape
        .regs   r40, beam_attenuates, beam_parallel, beam_kind
        .regs   r43, beam_x, beam_y, beam_z, beam_narrow, beam_low, beam_steep
        .regs   r49, beam_tightness, beam_fade, beam_power
        .endshare

        .data
        .align  64
attenuation_store: .space QUEUE         ; of all hits
        .code

; Clamps [v] to 0 .. 1.
        .macro  unit_range v
        CMPLTV  [\v], r0, [hits1]
        VTOV    r0, [\v] ? [hits1]
        CMPLTV  one, [\v], [hits1]
        VTOV    one, [\v] ? [hits1]
        .endm

        .macro  beam_across l, axis
        LINKV
        MPYSV   [v0], \axis, [v1]
        SUBNV   [\l], [v1], [\l]
        .endm

; Sets shadow_parallel, for the kernels that bound the rays: 1 if they are
; parallel.
        .macro  beam_shadows work, at
        RTOR    r0, \work
        IBXEQ   light_beam, r0, r0, beam_shadows\@
        RTOR    light_beam, \work
        IX      \work, 64 * BEAM_PARALLEL
        LOD     [\work], \work
beam_shadows\@:
        EX      \at, shadow_parallel
        STO     [\at], \work
        .endm

        .kernel shade
; Computes the direction to the light whose beam is light_beam.
;
; In:  lx ly lz = P - X.  Out: lx ly lz = L; [v0] = the distance; [v5] = the
;      distance from the axis of a cylinder.
beam_towards:
        RTOR    light_beam, s0
        ELEN    s0, BEAM_WORDS
        SWAP    [s0], beam_attenuates, [r0]
        IBXNE   beam_parallel, r0, r0, beam_parallel_rays
        normalise lx, ly, lz, v0, v1
        BIM     0, link_inner
beam_parallel_rays:
        dot_constant lx, ly, lz, beam_x, beam_y, beam_z, v0, v1
        IBXEQ   beam_kind, r0, r0, beam_directions
        beam_across lx, beam_x
        beam_across ly, beam_y
        beam_across lz, beam_z
        dot_vectors lx, ly, lz, lx, ly, lz, v5, v1
        SQRTV   [v5], [v5]
beam_directions:
        VTOV    beam_x, [lx]
        VTOV    beam_y, [ly]
        VTOV    beam_z, [lz]
        BIM     0, link_inner

; Computes the attenuation in attenuation_store.
;
; In:  the results of beam_towards; hits3: the s8 points that face the light.
; Out: hits3, s8: those that the light reaches; ndotl = 0 for the others.
; Changes v0-v7, hits1, hits2, s0, s1.
find_attenuation:
        VTOV    [v0], [v6]
        VTOV    one, [v7]
        IBXEQ   beam_kind, r0, r0, attenuation_fading
        IBXNE   beam_kind, r0, one_index, attenuation_cylinder
        dot_constant lx, ly, lz, beam_x, beam_y, beam_z, v0, v1
        BIM     attenuation_edge
attenuation_cylinder:
        LINKV
        MPYSV   [v5], beam_narrow, [v0]
        SUBNV   one, [v0], [v0]
        CMPLTV  r0, [v6], [hits1]
        VTOV    r0, [v0] ?! [hits1]
attenuation_edge:
        CMPLTV  r0, [v0], [hits1]
        ANDB    [hits1], [hits3], [hits3]
        LINKV
        SUBNV   [v0], beam_low, [v1]
        MPYSV   [v1], beam_steep, [v1]
        unit_range v1
        MPYSV   [v1], [v1], [v7]
        ADDN    one, two, s0
        LINKV
        MPYSV   [v1], two, [v2]
        SUBNV   s0, [v2], [v2]
        MPYSV   [v2], [v7], [v7]
        CFPEQ   beam_tightness, r0, attenuation_fading
        MASKV   [v0], one, [v0] ? [hits3]
        RTOR    beam_tightness, exponent
        EX      target, power
        BSAVE   link_inner, [target]
        MPYSV   [v7], [v0], [v7]
attenuation_fading:
        CFPEQ   beam_power, r0, attenuation_found
        ABSV    [v6], [v0]
        MPYSV   [v0], beam_fade, [v0]
        CMPLTV  one, [v0], [hits2]      ; farther than fade_distance
        DIVSV   one, [v0], [v1]
        VTOV    [v1], [v0] ? [hits2]
        MASKV   [v0], one, [v0] ? [hits3]
        RTOR    beam_power, exponent
        EX      target, power
        BSAVE   link_inner, [target]
        ADDNV   [v0], one, [v1]
        MASKV   [v0], one, [v0] ? [hits2]
        MPYSV   [v0], two, [v0]
        DIVSV   [v0], [v1], [v0]
        MPYSV   [v7], [v0], [v7]
attenuation_found:
        CMPLTV  r0, [v7], [hits1]
        ANDB    [hits1], [hits3], [hits3]
        CNTOB   [hits3], s8
        VTOV    r0, [ndotl] ?! [hits3]
        describe s0, attenuation_store, h
        VTOV    [v7], [s0]
        VTOV    [v6], [v0]
        BIM     0, link
        .endkernel

; Computes one channel of the light that reaches the hits: the attenuation times
; the light's colour or its transmitted part.
        .macro  attenuate_channel light, number
        describe s1, hit_tint_store + 64 * QUEUE * \number, h
        IBXNE   tinted, r0, r0, attenuate_tinted\@
        MPYSV   [s0], \light, [s1]
        BIM     attenuate_channel\@
attenuate_tinted\@:
        MPYSV   [s0], [s1], [s1]
attenuate_channel\@:
        .endm

        .macro  attenuate_light
        IBXEQ   light_beam, r0, r0, attenuate_light\@
        LOD     [light_beam], s0
        IBXEQ   s0, r0, r0, attenuate_light\@
        describe s0, attenuation_store, h
        attenuate_channel light_r, 0
        attenuate_channel light_g, 1
        attenuate_channel light_b, 2
        ES      tinted, 1
attenuate_light\@:
        .endm
