; light_vector.s - computes the light of one source at the hits of a queue
; (light.s).
;
; In:  light_at; the hits and their parts.
; Out: added to red, green, blue.

        .share  scratch
        .regs   r241, light_x, light_y, light_z, light_r, light_g, light_b
        .regs   r247, light_highlights
        .endshare
        .share  phase
        .regs   r196, tint_r, tint_g, tint_b    ; the transmitted light
        .regs   r185, tinted, link_shadow       ; tinted = 1: tint_r .. are set
        .reg    link_light, r191
        .endshare

; Describes the transmitted light of a part of the hits.
        .macro  tint_of_part tint, number
        describe \tint, hit_tint_store + 64 * QUEUE * \number, m
        ADDX    \tint, part_offset, \tint
        .endm

; Computes the limits of rays to the light's own position.
        .macro  end_before_light
        load_word k_shadow, s0
        SUBNV   [v0], s0, [v0]
        .endm

        .include "light/light.s"

        .if     BEAMS
        .share  scratch
        .reg    light_beam, r248        ; after the light's other words
        .endshare

        .data
        .align  64
attenuation_store: .space QUEUE         ; of all hits
        .code

; Sets shadow_parallel, for the kernels that bound the rays: 1 if they are
; parallel.
        .macro  beam_shadows work
        RTOR    r0, \work
        IBXEQ   light_beam, r0, r0, beam_shadows\@
        load_of light_beam, BEAM_PARALLEL, \work
beam_shadows\@:
        store_word \work, shadow_parallel, shape_at
        .endm

        .kernel shade
beam_towards:
        find_beam_direction
        BIM     0, link_inner

; Computes the attenuation in attenuation_store.
;
; In:  the results of beam_towards; hits3: the s8 points that face the light.
; Out: hits3, s8: those that the light reaches; ndotl = 0 for the others.
; Changes v0-v7, hits1, hits2, s0, s1.
find_attenuation:
        VTOV    [v0], [v6]
        .reg    light_distance, v6
        compute_attenuation 0
        .reg    light_distance, v0
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
        .endif
        .if     AREAS
        .include "light/area_vector.s"
        .endif

        .macro  load_light
        load_from light_at, LIGHT_SIZE, light_x
        .endm

        .kernel shade
illuminate:
        RTOR    link, link_light
        load_light
        call_routine set_hits, link_inner
        find_light_direction
        CMPLTV  r0, [ndotl], [hits3]
        CNTOB   [hits3], s8
        ES      tinted, 0
        IBXEQ   s8, r0, r0, illuminate_none
        .if     BEAMS
        IBXEQ   light_beam, r0, r0, illuminate_cast
        call_routine find_attenuation, link
        IBXEQ   s8, r0, r0, illuminate_none
illuminate_cast:
        .endif
        CFPEQ   light_highlights, r0, illuminate_parts  ; shadowless
        .if     AREAS
        area_of_light s0, illuminate_point
        call_routine cast_from_area, link
        BIM     illuminate_parts
illuminate_point:
        end_before_light
        RTOR    light_at, shadows
        .endif
        call_routine cast_shadows, link
illuminate_parts:
        .if     BEAMS
        attenuate_light
        .endif
        parts_begin
illuminate_next:
        part_begin
        load_record P_FINISH, 8, f_ambientr
        .if     GLOSS
        load_record P_GLOSS, 2, f_brilliance
        .endif
        IBXNE   tinted, r0, r0, illuminate_tinted
        shine   light_r, light_g, light_b
        BIM     illuminate_parts_next
illuminate_tinted:
        tint_of_part tint_r, 0
        tint_of_part tint_g, 1
        tint_of_part tint_b, 2
        shine   [tint_r], [tint_g], [tint_b]
illuminate_parts_next:
        parts_next illuminate_next
illuminate_none:
        BIM     0, link_light
        .endkernel
