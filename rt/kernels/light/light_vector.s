; light_vector.s - computes the light of one source at the hits of a queue.
;
; P is the position of the light, L = P - X normalised, l the light's colour or
; the part of it that reaches X (shadow_vector.s).  If N.L > 0, the light adds
;
;   + diffuse N.L c l
; and, if it makes highlights:
;   + phong l (R.L)^phong_size,      R = D - 2 (N.D) N, where R.L > 0
;   + specular l (N.H)^(1/roughness), H = (L - D) / |L - D|
;
; with R.L = D.L - 2 (N.D)(N.L) and N.H = (N.L - N.D) / sqrt(2 - 2 D.L).
; If L or H has no length, these are indefinite, which is not above 0: the light
; or the highlight adds nothing.  beam.s defines L and l for lights that do not
; shine in all directions or that fade.
;
; In:  light_at; the hits and their parts.
; Out: added to red, green, blue.
; Source: POV-Ray's finish.

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

        .macro  tints_of_part
        tint_of_part tint_r, 0
        tint_of_part tint_g, 1
        tint_of_part tint_b, 2
        .endm

; Computes the limits of rays to the light's own position.
        .macro  end_before_light
        load_word k_shadow, s0
        SUBNV   [v0], s0, [v0]
        .endm

        .if     BEAMS
        .include "light/beam_vector.s"
        .endif
        .if     AREAS
        .include "light/area_vector.s"
        .endif

        .macro  load_light
        ELEN    light_at, LIGHT_SIZE
        SWAP    [light_at], light_x, [r0]
        .endm

; Adds the light of one source to a channel.
        .macro  add_light strength, light, channel
        MPYSV   [\strength], \light, [v1]
        ADDNV   [\channel], [v1], [\channel] ? [hits0]
        .endm

        .if     GLOSS
        .include "light/gloss.s"
        .else
        .macro  add_highlight amount, light_r, light_g, light_b
        MPYSV   [v0], \amount, [v0]
        add_light v0, \light_r, red
        add_light v0, \light_g, green
        add_light v0, \light_b, blue
        .endm
        .endif

        .macro  add_diffuse light, pigment, channel
        MPYSV   [v0], \light, [v1]
        MPYSV   [v1], [\pigment], [v1]
        ADDNV   [\channel], [v1], [\channel] ? [hits3]
        .endm

; Adds the light to a part of the hits; light_r .. are numbers or vectors.
        .macro  illuminate_part light_r, light_g, light_b
        CMPLTV  r0, [ndotl], [hits3]
        CNTOB   [hits3], s0
        IBXEQ   s0, r0, r0, illuminate_done\@
        .if     GLOSS
        find_diffuse
        .else
        MPYSV   [ndotl], f_diffuse, [v0]
        .endif
        add_diffuse \light_r, cr, red
        add_diffuse \light_g, cg, green
        add_diffuse \light_b, cb, blue
        CFPEQ   light_highlights, r0, illuminate_done\@
        ADDN    f_phong, f_specular, s0
        CFPGE   r0, s0, illuminate_done\@
        dot_vectors hdx, hdy, hdz, lx, ly, lz, v6, v0
        .if     GLOSS
        find_metal
        .endif
        CFPGE   r0, f_phong, illuminate_no_phong\@
        MPYSV   [facing], two, [v0]
        MPYSV   [v0], [ndotl], [v0]
        SUBNV   [v6], [v0], [v0]
        CMPLTV  r0, [v0], [hits0]
        ANDB    [hits0], [hits3], [hits0]
        CNTOB   [hits0], s0
        IBXEQ   s0, r0, r0, illuminate_no_phong\@
        MASKV   [v0], one, [v0] ? [hits0]
        RTOR    f_size, exponent
        EX      target, power
        BSAVE   link_inner, [target]
        add_highlight f_phong, \light_r, \light_g, \light_b
illuminate_no_phong\@:
        CFPGE   r0, f_specular, illuminate_done\@
        LINKV
        MPYSV   [v6], two, [v0]
        SUBNV   two, [v0], [v1]
        SUBNV   [ndotl], [facing], [v0]
        SQRTV   [v1], [v1] ? [hits3]
        MASKV   [v1], one, [v1] ? [hits3]
        DIVSV   [v0], [v1], [v0]
        CMPLTV  r0, [v0], [hits0]
        ANDB    [hits0], [hits3], [hits0]
        CNTOB   [hits0], s0
        IBXEQ   s0, r0, r0, illuminate_done\@
        MASKV   [v0], one, [v0] ? [hits0]
        RTOR    f_sharpness, exponent
        EX      target, power
        BSAVE   link_inner, [target]
        add_highlight f_specular, \light_r, \light_g, \light_b
illuminate_done\@:
        .endm

        .kernel shade
illuminate:
        RTOR    link, link_light
        load_light
        EX      target, set_hits
        BSAVE   link_inner, [target]
        SUBNV   light_x, [px], [lx]
        SUBNV   light_y, [py], [ly]
        SUBNV   light_z, [pz], [lz]
        .if     BEAMS
        IBXNE   light_beam, r0, r0, illuminate_beam
        .endif
        normalise lx, ly, lz, v0, v1
        .if     BEAMS
        BIM     illuminate_direction
illuminate_beam:
        EX      target, beam_towards
        BSAVE   link_inner, [target]
illuminate_direction:
        .endif
        dot_vectors nx, ny, nz, lx, ly, lz, ndotl, v1
        CMPLTV  r0, [ndotl], [hits3]
        CNTOB   [hits3], s8
        ES      tinted, 0
        IBXEQ   s8, r0, r0, illuminate_none
        .if     BEAMS
        IBXEQ   light_beam, r0, r0, illuminate_cast
        EX      target, find_attenuation
        BSAVE   link, [target]
        IBXEQ   s8, r0, r0, illuminate_none
illuminate_cast:
        .endif
        CFPEQ   light_highlights, r0, illuminate_parts  ; shadowless
        .if     AREAS
        area_of_light s0, illuminate_point
        EX      target, cast_from_area
        BSAVE   link, [target]
        BIM     illuminate_parts
illuminate_point:
        end_before_light
        RTOR    light_at, shadows
        .endif
        EX      target, cast_shadows
        BSAVE   link, [target]
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
        illuminate_part light_r, light_g, light_b
        BIM     illuminate_parts_next
illuminate_tinted:
        tints_of_part
        illuminate_part [tint_r], [tint_g], [tint_b]
illuminate_parts_next:
        parts_next illuminate_next
illuminate_none:
        BIM     0, link_light
        .endkernel
