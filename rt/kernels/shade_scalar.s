; shade_scalar.s - the colour of one ray.
;
;       CALL SHADE (RAY, PRIMITIVE, DISTANCE, SAMPLE)
;
; RAY = O, D (6 words); PRIMITIVE = the record of what it hit; DISTANCE (1);
; SAMPLE = colour, normal (6).  Formulas and order of the operations as in
; shade_vector.s and normal_vector.s.

        .regs   r32, a_ray, a_primitive, a_distance, a_sample
        .regs   r36, lights_left, light_at, normal_link, pigment_at
        .regs   r40, link_saved, here
        .regs   r48, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9
        .regs   r58, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10
        .regs   r69, sh11, sh12, sh13, sh14, sh15
        .regs   r74, qx, qy, qz
        .regs   r77, red, green, blue, nx, ny, nz
        .regs   r83, color0r, color0g, color0b, color1r, color1g, color1b
        .regs   r89, lx, ly, lz, facing, ndotl, ddotl
        .regs   r95, transformed_shape
        .regs   r132, light_x, light_y, light_z, light_r, light_g, light_b
        .regs   r138, light_gleams
        .regs   r139, f_ambientr, f_ambientg, f_ambientb, f_diffuse, f_phong
        .regs   r144, f_size, f_specular, f_sharpness
        .regs   r147, ox, oy, oz, dx, dy, dz
        .regs   r153, px, py, pz
        .equ    SHADE_REGISTERS, 124

        .data
shade_save:     .space SHADE_REGISTERS
        .code

        .macro  load_field offset, register
        RTOR    a_primitive, here
        IX      here, 64 * (\offset)
        LOD     [here], \register
        .endm

        .macro  load_record offset, number, first
        RTOR    a_primitive, here
        IX      here, 64 * (\offset)
        ELEN    here, \number
        SWAP    [here], \first, [r0]
        .endm

        .macro  point o, d, p
        MPYS    t0, \d, t1
        ADDN    \o, t1, \p
        .endm

        .macro  own_point k0, k1, k2, k3, q
        dot     px, py, pz, \k0, \k1, \k2, \q, t0
        ADDN    \q, \k3, \q
        .endm

        .macro  pattern_floor k0, k1, k2, k3, sum
        dot     px, py, pz, \k0, \k1, \k2, t0, t1
        ADDN    t0, \k3, t0
        ADDN    t0, m_checker_shift, t0
        FLR     t0, \sum
        .endm

        .macro  add_light strength, light, channel
        MPYS    \strength, \light, t1
        ADDN    \channel, t1, \channel
        .endm

        .macro  add_highlight amount
        MPYS    p_x, \amount, t0
        add_light t0, light_r, red
        add_light t0, light_g, green
        add_light t0, light_b, blue
        .endm

        .macro  add_diffuse light, pigment, channel
        MPYS    t0, \light, t1
        MPYS    t1, \pigment, t1
        ADDN    \channel, t1, \channel
        .endm

        .kernel shade
shade:
        EX      save_at, shade_save
        ELEN    save_at, SHADE_REGISTERS
        SWAP    [r0], r32, [save_at]
        ELEN    arguments, 4
        SWAP    [arguments], a_ray, [r0]
        SWAP    [a_ray], ox, [r0]
        LOD     [a_distance], t0
        point   ox, dx, px
        point   oy, dy, py
        point   oz, dz, pz

; The normal, in the world, turned against the ray; facing = N . D.
        RTOR    px, qx
        RTOR    py, qy
        RTOR    pz, qz
        load_field P_TRANSFORMED, transformed_shape
        IBXEQ   transformed_shape, r0, r0, shade_own
        load_record P_LOCAL, 12, sh0
        own_point sh0, sh1, sh2, sh3, qx
        own_point sh4, sh5, sh6, sh7, qy
        own_point sh8, sh9, sh10, sh11, qz
shade_own:
        load_field P_NORMAL, target
        BSAVE   normal_link, [target]
        IBXEQ   transformed_shape, r0, r0, shade_world
        load_record P_LOCAL, 12, sh0
        dot     nx, ny, nz, sh0, sh4, sh8, lx, t0
        dot     nx, ny, nz, sh1, sh5, sh9, ly, t0
        dot     nx, ny, nz, sh2, sh6, sh10, lz, t0
        normalise_by m_one, lx, ly, lz, t0, t1
        RTOR    lx, nx
        RTOR    ly, ny
        RTOR    lz, nz
shade_world:
        dot     nx, ny, nz, dx, dy, dz, facing, t0
        CFPGE   r0, facing, shade_pigment
        SUBN    r0, nx, nx
        SUBN    r0, ny, ny
        SUBN    r0, nz, nz
        SUBN    r0, facing, facing

; The pigment: color0.
shade_pigment:
        load_record P_COLOR, 6, color0r
        load_field P_CHECKER, t0
        IBXEQ   t0, r0, r0, shade_ambient
        load_record P_PATTERN, 12, sh0
        pattern_floor sh0, sh1, sh2, sh3, t2
        pattern_floor sh4, sh5, sh6, sh7, t3
        pattern_floor sh8, sh9, sh10, sh11, t4
        ADDU    t2, t3, t2
        ADDU    t2, t4, t2
        AND     t2, m_index_one, t2
        CFPEQ   t2, r0, shade_ambient
        RTOR    color1r, color0r
        RTOR    color1g, color0g
        RTOR    color1b, color0b

shade_ambient:
        load_record P_FINISH, 8, f_ambientr
        MPYS    color0r, f_ambientr, red
        MPYS    color0g, f_ambientg, green
        MPYS    color0b, f_ambientb, blue
        EX      here, scene_lights
        LOD     [here], light_at
        EX      here, scene_light_count
        LOD     [here], lights_left
        IBXEQ   lights_left, r0, r0, shade_store
shade_light:
        ELEN    light_at, LIGHT_SIZE
        SWAP    [light_at], light_x, [r0]
        SUBN    light_x, px, lx
        SUBN    light_y, py, ly
        SUBN    light_z, pz, lz
        normalise_by m_one, lx, ly, lz, t0, t1
        dot     nx, ny, nz, lx, ly, lz, ndotl, t0
        CFPGE   r0, ndotl, shade_next_light
        CFPNE   ndotl, ndotl, shade_next_light  ; indefinite: L = 0
        MPYS    ndotl, f_diffuse, t0
        add_diffuse light_r, color0r, red
        add_diffuse light_g, color0g, green
        add_diffuse light_b, color0b, blue
        CFPEQ   light_gleams, r0, shade_next_light
        dot     dx, dy, dz, lx, ly, lz, ddotl, t0
        CFPGE   r0, f_phong, shade_no_phong
        MPYS    facing, m_two, t0
        MPYS    t0, ndotl, t0
        SUBN    ddotl, t0, p_x
        CFPGE   r0, p_x, shade_no_phong
        RTOR    f_size, exponent
        EX      target, power
        BSAVE   power_link, [target]
        add_highlight f_phong
shade_no_phong:
        CFPGE   r0, f_specular, shade_next_light
        MPYS    ddotl, m_two, t0
        SUBN    m_two, t0, t1
        SUBN    ndotl, facing, t0
        SQRT    t1, t1
        DIVS    t0, t1, p_x
        CFPGE   r0, p_x, shade_next_light
        CFPNE   p_x, p_x, shade_next_light      ; indefinite: L = D
        RTOR    f_sharpness, exponent
        EX      target, power
        BSAVE   power_link, [target]
        add_highlight f_specular
shade_next_light:
        IX      light_at, 64 * LIGHT_SIZE
        IBXNE   lights_left, m_index_minus_one, r0, shade_light, lights_left
shade_store:
        SWAP    [r0], red, [a_sample]
        leave   shade_save, SHADE_REGISTERS
        .endkernel
