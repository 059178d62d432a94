; light_scalar.s - computes the light of one source at one point.  The formulas
; are those of light_vector.s.  These macros are a part of the subroutines that
; shade.

        .if     BEAMS
        .include "light/beam_scalar.s"
        .endif

; Computes the direction lx, ly, lz to the light, its distance and N . L.
; Branches to none if the light does not face the surface.
        .macro  towards_light none
        SUBN    light_x, px, lx
        SUBN    light_y, py, ly
        SUBN    light_z, pz, lz
        .if     BEAMS
        IBXNE   light_beam, r0, r0, towards_beam\@
        .endif
        normalise_by m_one, lx, ly, lz, light_distance, t1
        .if     BEAMS
        BIM     towards_direction\@
towards_beam\@:
        beam_towards
towards_direction\@:
        .endif
        dot     nx, ny, nz, lx, ly, lz, ndotl, t0
        CFPGE   r0, ndotl, \none
        CFPNE   ndotl, ndotl, \none     ; indefinite: L = 0
        .if     BEAMS
        IBXEQ   light_beam, r0, r0, towards_lit\@
        find_attenuation \none
towards_lit\@:
        .endif
        .endm

        .macro  add_light strength, light, channel
        MPYS    \strength, \light, t1
        ADDN    \channel, t1, \channel
        .endm

        .if     GLOSS
        .include "light/gloss.s"
        .else
        .macro  add_highlight amount, light_r, light_g, light_b
        MPYS    p_x, \amount, t0
        add_light t0, \light_r, red
        add_light t0, \light_g, green
        add_light t0, \light_b, blue
        .endm
        .endif

        .macro  add_diffuse light, pigment, channel
        MPYS    t0, \light, t1
        MPYS    t1, \pigment, t1
        ADDN    \channel, t1, \channel
        .endm

; Adds diffuse light and highlights to red, green, blue.
        .macro  shine
        .if     GLOSS
        find_diffuse
        .else
        MPYS    ndotl, f_diffuse, t0
        .endif
        add_diffuse light_r, color0r, red
        add_diffuse light_g, color0g, green
        add_diffuse light_b, color0b, blue
        CFPEQ   light_highlights, r0, shine_end\@
        .if     GLOSS
        find_metal
        .endif
        dot     dx, dy, dz, lx, ly, lz, ddotl, t0
        CFPGE   r0, f_phong, shine_no_phong\@
        MPYS    facing, m_two, t0
        MPYS    t0, ndotl, t0
        SUBN    ddotl, t0, p_x
        CFPGE   r0, p_x, shine_no_phong\@
        RTOR    f_size, exponent
        EX      target, power
        BSAVE   power_link, [target]
        add_highlight f_phong, light_r, light_g, light_b
shine_no_phong\@:
        CFPGE   r0, f_specular, shine_end\@
        MPYS    ddotl, m_two, t0
        SUBN    m_two, t0, t1
        SUBN    ndotl, facing, t0
        SQRT    t1, t1
        DIVS    t0, t1, p_x
        CFPGE   r0, p_x, shine_end\@
        CFPNE   p_x, p_x, shine_end\@   ; indefinite: L = D
        RTOR    f_sharpness, exponent
        EX      target, power
        BSAVE   power_link, [target]
        add_highlight f_specular, light_r, light_g, light_b
shine_end\@:
        .endm
