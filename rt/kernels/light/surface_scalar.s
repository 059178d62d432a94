; surface_scalar.s - computes a surface point that is to be lit: its normal and
; pigment.  These macros and registers are a part of the subroutines that shade.

        .share  local
        .regs   r32, a_ray, primitive, a_distance, a_sample
        .regs   r36, lights_left, light_at, normal_link, transformed_shape
        .regs   r40, link_saved, here
        .regs   r42, color0r, color0g, color0b, color1r, color1g, color1b
        .regs   color0r, cr, cg, cb
        .regs   r48, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9
        .regs   r58, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10
        .regs   r69, sh11, sh12, sh13, sh14, sh15
        .regs   r74, qx, qy, qz
        .regs   r77, red, green, blue, nx, ny, nz       ; the sample
        .regs   r83, facing, outward, cell
        .regs   r86, px, py, pz
        .regs   r89, lx, ly, lz
        .regs   r92, ndotl, ddotl, light_distance
        .regs   r132, light_x, light_y, light_z, light_r, light_g, light_b
        .if     BEAMS
        .regs   r138, light_highlights, light_beam
        .else
        .reg    light_highlights, r138
        .endif
        .endshare

; The finish, in the registers of the beam until the light is computed.
        .share  local
        .regs   r139, f_ambientr, f_ambientg, f_ambientb, f_diffuse, f_phong
        .regs   r144, f_size, f_specular, f_sharpness
        .regs   r147, ox, oy, oz, dx, dy, dz
        .regs   dx, hdx, hdy, hdz
        .endshare
        .equ    SHADE_REGISTERS, 121

; A sample, in the order of these registers.
        .record SAMPLE
        .field  SAMPLE_COLOR, 3
        .field  SAMPLE_NORMAL, 3        ; turned against the ray
        .field  SAMPLE_FACING           ; N . D
        .field  SAMPLE_OUTWARD          ; the same for the outward normal
        .field  SAMPLE_CELL             ; offset of the colour
        .field  SAMPLE_POINT, 3
        .if     BUMPS
        .field  SAMPLE_BEFORE, 3        ; the normal without bumps
        .endif
        .endrecord

; Copies the normal without bumps to its place in the sample, at the end.
        .macro  give_normal_before
        .if     BUMPS
        copy_three raw_x, raw_y, raw_z, lx, ly, lz
        .endif
        .endm

        .macro  point o, d, p
        MPYS    t0, \d, t1
        ADDN    \o, t1, \p
        .endm

; Computes the point at the distance t0 and the world normal there, turned
; against the ray; facing = N . D, outward = the same before the normal was
; turned.
        .macro  find_surface
        three   point, ox, oy, oz, dx, dy, dz, px, py, pz
        copy_three px, py, pz, qx, qy, qz
        load_field P_TRANSFORMED, transformed_shape
        IBXEQ   transformed_shape, r0, r0, surface_local\@
        load_record P_LOCAL, 12, sh0
        local_coordinate sh0, sh1, sh2, sh3, qx
        local_coordinate sh4, sh5, sh6, sh7, qy
        local_coordinate sh8, sh9, sh10, sh11, qz
surface_local\@:
        load_field P_NORMAL, target
        BSAVE   normal_link, [target]
        IBXEQ   transformed_shape, r0, r0, surface_world\@
        load_record P_LOCAL, 12, sh0
        dot     nx, ny, nz, sh0, sh4, sh8, lx, t0
        dot     nx, ny, nz, sh1, sh5, sh9, ly, t0
        dot     nx, ny, nz, sh2, sh6, sh10, lz, t0
        normalise_by m_one, lx, ly, lz, t0, t1
        copy_three lx, ly, lz, nx, ny, nz
surface_world\@:
        dot     nx, ny, nz, dx, dy, dz, facing, t0
        RTOR    facing, outward
        CFPGE   r0, facing, surface_turned\@
        three_by SUBN, r0, nx, ny, nz, nx, ny, nz
        SUBN    r0, facing, facing
surface_turned\@:
        .if     MESH_CROSSINGS
        load_field P_ON_PATCH, t0
        ES      t1, 2
        IBXNE   t0, r0, t1, surface_sided\@
        load_field P_PATCH_POINT + 1, t0         ; hit_t: it enters or leaves
        RTOR    facing, outward
        IBXEQ   t0, r0, r0, surface_sided\@
        SUBN    r0, facing, outward
surface_sided\@:
        .endif
        .if     BUMPS
        change_normal
        .endif
        .endm

        .if     BUMPS
        .include "light/bump.s"
        .endif

; Computes the pigment color0 and loads words of the finish; red, green, blue
; start with the ambient light.
        .macro  begin_colour words
        load_record P_COLOR, 6, color0r
        checker_cell pigment_found\@, pigment_gradient\@
        IBXEQ   cell, r0, r0, pigment_found\@
        copy_three color1r, color1g, color1b, color0r, color0g, color0b
        BIM     pigment_found\@
pigment_gradient\@:
        .if     PATTERNS
        ES      t1, 2
        IBXEQ   t0, r0, t1, pigment_slope\@
        load_record P_PATTERN, 12, sh0
        load_record P_MAP, MAP_SIZE, map_function
        pattern_colour
        .if     IMAGES
        RTOR    image_cell, cell
        IBXEQ   cell, r0, r0, pigment_found\@
        copy_three color1r, color1g, color1b, color0r, color0g, color0b
        .endif
        BIM     pigment_found\@
pigment_slope\@:
        .endif
        load_record P_PATTERN, 6, sh0
        gradient_colour
pigment_found\@:
        load_record P_FINISH, \words, f_ambientr
        MPYS    color0r, f_ambientr, red
        MPYS    color0g, f_ambientg, green
        MPYS    color0b, f_ambientb, blue
        .endm
