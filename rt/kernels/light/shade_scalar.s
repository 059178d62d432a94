; shade_scalar.s - computes the colour of one ray.
;
;       CALL SHADE (RAY, PRIMITIVE, DISTANCE, SAMPLE)
;
; RAY = O, D (6 words); PRIMITIVE = the record of the primitive that it hit;
; DISTANCE (1 word); SAMPLE = colour, normal turned against the ray, N . D, the
; same for the outward normal, the offset of the pigment's colour
; (pigment_scalar.s), point (12 words).  With finishes that depend on the angle
; there is another argument: PIGMENT = the pigment's colour (3 words).  The
; formulas and the order of the operations are those of shade_vector.s,
; pigment_vector.s and light_vector.s, but the light of a source that does not
; reach the point is not computed.

        .data
shade_save:     .space SHADE_REGISTERS
shadow_list:    .descriptor 6, shadow_ray
                .descriptor 1, shadow_limit
                .descriptor 3, shadow_light
shadow_ray:     .space 8
shadow_limit:   .space 2                ; the target follows, or 0: no point
shadow_light:   .space 3
        .code

        .if     GLOSS
        .share  local
        .reg    a_pigment, r138         ; until the light is computed
        .endshare
        .equ    SHADE_ARGUMENTS, 5
        .else
        .equ    SHADE_ARGUMENTS, 4
        .endif

; Traces the ray of shadow_ray up to limit.  position = the address of its
; target.  here = the address of the remaining light.
        .macro  cast_shadow limit, position
        store_word \limit, shadow_limit, here
        RTOR    \position, t1
        .if     BEAMS
        IBXEQ   light_beam, r0, r0, cast_to_place\@
        IBXEQ   beam_parallel, r0, r0, cast_to_place\@
        RTOR    r0, t1
cast_to_place\@:
        .endif
        STO     [here, m_index_one], t1
        store_words light_r, 3, shadow_light
        call    shadow, shadow_list
        EX      here, shadow_light
        .endm

        .if     AREAS
        .include "light/area_scalar.s"
        .endif

        .kernel shade
shade:
        store_words r32, SHADE_REGISTERS, shade_save
        RTOR    link, link_saved
        load_from arguments, SHADE_ARGUMENTS, a_ray
        .if     GLOSS
        RTOR    lights_left, a_pigment
        .endif
        SWAP    [a_ray], ox, [r0]
        LOD     [a_distance], t0
        find_surface
        begin_colour 8
        .if     GLOSS
        store_to color0r, 3, a_pigment
        load_record P_GLOSS, 2, f_brilliance
        .endif
        load_words scene_lights, 2, t0
        RTOR    t0, light_at
        RTOR    t1, lights_left
        IBXEQ   lights_left, r0, r0, shade_store
shade_light:
        load_from light_at, LIGHT_SIZE, light_x
        towards_light shade_next_light
        CFPEQ   light_highlights, r0, shade_lit
        store_words px, 6, shadow_ray
        .if     AREAS
        area_of_light shade_point_light
        light_of_area
        BIM     shade_passed
shade_point_light:
        .endif
        EX      here, k_shadow
        LOD     [here], t0
        SUBN    light_distance, t0, t0
        cast_shadow t0, light_at
        load_from here, 3, light_r
shade_passed:
        CFPNE   light_r, r0, shade_lit
        CFPNE   light_g, r0, shade_lit
        CFPEQ   light_b, r0, shade_next_light
shade_lit:
        .if     BEAMS
        IBXEQ   light_beam, r0, r0, shade_all_around
        IBXEQ   beam_attenuates, r0, r0, shade_all_around
        attenuate_light
shade_all_around:
        .endif
        shine   light_r, light_g, light_b
shade_next_light:
        IX      light_at, 64 * LIGHT_SIZE
        IBXNE   lights_left, m_index_minus_one, r0, shade_light, lights_left
shade_store:
        give_normal_before
        SWAP    [r0], red, [a_sample]
        RTOR    link_saved, link
        leave   shade_save, SHADE_REGISTERS
        .endkernel
