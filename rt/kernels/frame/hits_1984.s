; hits_1984.s - the scalar program's shading of one hit.
;
;       CALL SURFACE (HIT)
;       CALL TOWARDS (HIT, LIGHT)
;       CALL SHINE (HIT, LIGHT)
;
; HIT is the record of a hit (HIT_SIZE words, below). LIGHT is the record of a
; light; for SHINE it contains the colour that reaches the point (7 words).
; SURFACE computes point, normal and pigment and initialises the colour with the
; ambient light. TOWARDS computes the direction to a light, with N . L = 0 if
; the light is on the other side of the surface. SHINE adds its light. Formulas:
; surface_scalar.s, light.s.

        .record HIT
        .field  HIT_RAY, 6              ; O, D
        .field  HIT_DISTANCE
        .field  HIT_PRIMITIVE           ; address of its record
        .field  HIT_INDEX               ; position of its ray in the queue
        .field  HIT_SAMPLE, SAMPLE_SIZE ; as in SHADE
        .field  HIT_LIGHT, 3            ; L
        .field  HIT_NDOTL               ; N . L, D . L, distance
        .field  HIT_DDOTL
        .field  HIT_TO_LIGHT
        .field  HIT_PIGMENT, 3
        .field  HIT_ATTENUATION         ; dimming by a beam
        .if     BUMPS
        .at     35              ; odd, against bank conflicts
        .else
        .at     32
        .endif
        .endrecord

        .share  local
        .regs   r34, a_hit, a_light
        .regs   r147, ox, oy, oz, dx, dy, dz, hit_distance, hit_primitive
        .endshare

        .equ    SURFACE_REGISTERS, SHADE_REGISTERS + 2

        .data
hit_save:       .space SURFACE_REGISTERS
        .code

        .macro  enter_hit arguments_count, registers
        store_words r32, \registers, hit_save
        load_from arguments, \arguments_count, a_hit
        .endm

        .macro  store_hit offset, number, first
        store_part \first, \number, a_hit, \offset, here
        .endm

        .kernel shade
surface:
        enter_hit 1, SURFACE_REGISTERS
        load_part a_hit, HIT_RAY, HIT_INDEX, ox
        RTOR    hit_primitive, primitive
        RTOR    hit_distance, t0
        find_surface
        begin_colour 3
        give_normal_before
        store_hit HIT_SAMPLE, SAMPLE_SIZE, red
        store_hit HIT_PIGMENT, 3, color0r
        leave   hit_save, SURFACE_REGISTERS

; TOWARDS and SHINE need fewer registers.
        .share  local
        .regs   r32, a_hit, a_light, primitive, t0, t1, here
        .regs   r38, red, green, blue, nx, ny, nz, facing, outward, cell
        .regs   r47, px, py, pz, lx, ly, lz, ndotl, ddotl, light_distance
        .regs   r56, light_x, light_y, light_z, light_r, light_g, light_b
        .if     BEAMS
        .regs   r62, light_highlights, light_beam
        .else
        .reg    light_highlights, r62
        .endif
        .endshare

; The ray. Its registers hold the beam until the light is known.
        .share  local
        .regs   r63, ox, oy, oz, dx, dy, dz, hit_distance, hit_primitive
        .regs   dx, hdx, hdy, hdz
        .regs   r71, color0r, color0g, color0b
        .regs   color0r, cr, cg, cb
        .regs   r74, f_ambientr, f_ambientg, f_ambientb, f_diffuse, f_phong
        .regs   r79, f_size, f_specular, f_sharpness
        .endshare
        .if     BEAMS
        .share  local
        .regs   r64, beam_attenuates, beam_parallel, beam_kind
        .regs   r67, beam_x, beam_y, beam_z, beam_narrow, beam_low, beam_steep
        .regs   r73, beam_tightness, beam_fade, beam_power
        .regs   r76, beam_off, beam_q, beam_three
        .reg    attenuation, r33        ; register of a_light, free once loaded
        .endshare
        .equ    TOWARDS_REGISTERS, 47
        .else
        .equ    TOWARDS_REGISTERS, 31
        .endif
        .if     GLOSS
        .equ    SHINE_REGISTERS, GLOSS_REGISTERS
        .else
        .equ    SHINE_REGISTERS, 50
        .endif

towards:
        enter_hit 2, TOWARDS_REGISTERS
        load_from a_light, LIGHT_SIZE, light_x
        load_part a_hit, HIT_SAMPLE, SAMPLE_SIZE, red
        towards_light towards_none
        BIM     towards_found
towards_none:
        RTOR    m_zero, ndotl
towards_found:
        store_hit HIT_LIGHT, 6, lx
        .if     BEAMS
        store_hit HIT_ATTENUATION, 1, attenuation
        .endif
        leave   hit_save, TOWARDS_REGISTERS

shine:
        enter_hit 2, SHINE_REGISTERS
        load_from a_light, LIGHT_SIZE, light_x
        .if     BEAMS
        IBXEQ   light_beam, r0, r0, shine_all_around
        load_part a_hit, HIT_ATTENUATION, 1, attenuation
        attenuate_light
shine_all_around:
        .endif
        load_part a_hit, HIT_RAY, HIT_INDEX, ox
        RTOR    hit_primitive, primitive
        .if     BUMPS
        load_part a_hit, HIT_SAMPLE, SAMPLE_SIZE, red
        load_part a_hit, HIT_LIGHT, 6, lx
        .else
        load_part a_hit, HIT_SAMPLE, SAMPLE_SIZE + 6, red
        .endif
        load_part a_hit, HIT_PIGMENT, 3, color0r
        load_record P_FINISH, 8, f_ambientr
        .if     GLOSS
        load_record P_GLOSS, 2, f_brilliance
        .endif
        shine   light_r, light_g, light_b
        store_hit HIT_SAMPLE, 3, red
        leave   hit_save, SHINE_REGISTERS
        .endkernel
