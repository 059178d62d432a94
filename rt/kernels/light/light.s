; light.s - the light of one source at points, in both forms.
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
; Source: POV-Ray's finish.

; p_x = p_x ^ k.
        .macro  power_of k
        RTOR    \k, exponent
        call_routine power, power_link
        .endm

        .if     BEAMS
        .include "light/beam.s"
        .endif

; Computes the direction lx, ly, lz to the light, its distance and N . L.
        .macro  find_light_direction
        three   from, light_x, light_y, light_z, px, py, pz, lx, ly, lz
        .if     BEAMS
        IBXNE   light_beam, r0, r0, towards_beam\@
        .endif
        unit_vector lx, ly, lz, light_distance, t1
        .if     BEAMS
        BIM     towards_direction\@
towards_beam\@:
        beam_towards
towards_direction\@:
        .endif
        dot_product nx, ny, nz, lx, ly, lz, ndotl, t1
        .endm

; Adds the light of strength to a channel.
        .macro  add_light strength, light, channel
        scale   \strength, \light, t1
        add_where hits0, t1, \channel
        .endm

        .macro  add_diffuse light, pigment, channel
        scale   t0, \light, t1
        times   t1, \pigment, t1
        add_where hits3, t1, \channel
        .endm

        .if     GLOSS
        .include "light/gloss.s"
        .else
        .macro  add_highlight amount, light_r, light_g, light_b
        scale   p_x, \amount, t0
        three_by add_light, t0, \light_r, \light_g, \light_b, red, green, blue
        .endm
        .endif

; Adds diffuse light and highlights to red, green, blue.
        .macro  shine light_r, light_g, light_b
        leave_if_dark shine_end\@
        .if     GLOSS
        find_diffuse
        .else
        scale   ndotl, f_diffuse, t0
        .endif
        three   add_diffuse, \light_r, \light_g, \light_b, cr, cg, cb, red, green, blue
        CFPEQ   light_highlights, r0, shine_end\@
        leave_if_matt shine_end\@
        dot_product hdx, hdy, hdz, lx, ly, lz, ddotl, t0
        .if     GLOSS
        find_metal
        .endif
        CFPGE   r0, f_phong, shine_no_phong\@
        scale   facing, m_two, t0
        times   t0, ndotl, t0
        minus   ddotl, t0, p_x
        base_of_highlight p_x, shine_no_phong\@
        power_of f_size
        add_highlight f_phong, \light_r, \light_g, \light_b
shine_no_phong\@:
        CFPGE   r0, f_specular, shine_end\@
        from_scaled m_two, ddotl, m_two, t1
        minus   ndotl, facing, t0
        root_lit t1
        quotient t0, t1, p_x
        base_of_highlight p_x, shine_end\@
        leave_if_indefinite p_x, shine_end\@   ; L = D
        power_of f_sharpness
        add_highlight f_specular, \light_r, \light_g, \light_b
shine_end\@:
        .endm
