; shade_vector.s - the colours of a queue of rays.
;
; Primitive by primitive: the m rays that hit it are found by one compare and
; one compress of 0, 1, 2 ...; the list gathers their points and directions
; and in the end scatters their colours.  At a point X with unit normal N
; turned towards the eye, ray direction D, pigment c:
;
;   colour = ambient c
;   for each light at P with colour l, L = P - X made a unit vector, where
;   N.L > 0:
;     + diffuse N.L c l
;   and, if the light makes highlights:
;     + phong l (R.L)^phong_size,      R = D - 2 (N.D) N, where R.L > 0
;     + specular l (N.H)^(1/roughness), H = (L - D) / |L - D|
;   with R.L = D.L - 2 (N.D)(N.L) and N.H = (N.L - N.D) / sqrt(2 - 2 D.L).
; Where L or H has no length these are indefinite, which is not above 0: such a
; light, such a highlight is left out.
;
; In:  the queue's rays, nearest, nearest_id; the scene.
; Out: the frame's planes from the queue's first pixel on.
; Source: POV-Ray's finish (phong and Blinn's halfway vector); no shadows.

        .regs   r233, f_ambientr, f_ambientg, f_ambientb, f_diffuse, f_phong
        .regs   r238, f_size, f_specular, f_sharpness
        .regs   r241, light_x, light_y, light_z, light_r, light_g, light_b
        .regs   r247, light_gleams
        .regs   r248, color0r, color0g, color0b, color1r, color1g, color1b
        .reg    shade_left, r188

        .reg    link_shade, r190
        .reg    link_light, r191

; The points where the rays hit, and their directions.
        .macro  point o, d, p, hd
        VXTOV   [at], [\o], [\p]
        VXTOV   [at], [\d], [\hd]
        MPYSV   [v0], [\hd], [v1]
        ADDNV   [\p], [v1], [\p]
        .endm

        .kernel shade
shade:
        EX      s0, scene_background
        ELEN    s0, 3
        SWAP    [s0], s1, [r0]
        VTOV    s1, [out_red]
        VTOV    s2, [out_green]
        VTOV    s3, [out_blue]
        VTOV    r0, [out_depth]
        CMPNEV  [nearest_id], r0, [bits0]
        VTOV    [nearest], [out_depth] ? [bits0]
        VTOV    r0, [out_nx]
        VTOV    r0, [out_ny]
        VTOV    r0, [out_nz]
        VTOV    [nearest_id], [out_id]
        EX      s0, scene_primitives
        LOD     [s0], primitive
        EX      s0, scene_primitive_count
        LOD     [s0], shade_left
        IBXEQ   shade_left, r0, r0, shade_done
shade_next:
        load_field P_ID, identity
        CMPEQV  [nearest_id], identity, [bits0]
        CPSV    [iota], [at] ? [bits0]
        LTOR    at, m
        IBXEQ   m, r0, r0, shade_no_hit
        set_lengths m, m_high, shade_bases, shade_descriptors, SHADE_VECTORS, at
        EX      target, shade_primitive
        BSAVE   link_kernel, [target]
shade_no_hit:
        IX      primitive, 64 * P_SIZE
        IBXNE   shade_left, minus_one_index, r0, shade_next, shade_left
shade_done:
        BIM     0, link

; The m rays that hit this primitive.
shade_primitive:
        RTOR    link_kernel, link_shade
        VXTOV   [at], [nearest], [v0]
        point   wox, wdx, px, hdx
        point   woy, wdy, py, hdy
        point   woz, wdz, pz, hdz
        EX      target, find_normal
        BSAVE   link_kernel, [target]
        EX      target, find_pigment
        BSAVE   link_kernel, [target]
        load_record P_FINISH, 8, f_ambientr
        MPYSV   [cr], f_ambientr, [red]
        MPYSV   [cg], f_ambientg, [green]
        MPYSV   [cb], f_ambientb, [blue]
        EX      s0, scene_lights
        LOD     [s0], light_at
        EX      s0, scene_light_count
        LOD     [s0], lights_left
        IBXEQ   lights_left, r0, r0, shade_store_colours
shade_light:
        ELEN    light_at, LIGHT_SIZE
        SWAP    [light_at], light_x, [r0]
        EX      target, illuminate
        BSAVE   link_kernel, [target]
        IX      light_at, 64 * LIGHT_SIZE
        IBXNE   lights_left, minus_one_index, r0, shade_light, lights_left
shade_store_colours:
        VTOVX   [at], [red], [out_red]
        VTOVX   [at], [green], [out_green]
        VTOVX   [at], [blue], [out_blue]
        VTOVX   [at], [nx], [out_nx]
        VTOVX   [at], [ny], [out_ny]
        VTOVX   [at], [nz], [out_nz]
        BIM     0, link_shade

; The normal at the points, in the world, turned against the ray; facing =
; its product with the ray's direction.
find_normal:
        RTOR    link_kernel, link_inner
        look_at_points px, py, pz
        load_field P_TRANSFORMED, s9
        IBXEQ   s9, r0, r0, normal_own
        load_record P_LOCAL, 12, m00
        dot_constant px, py, pz, m00, m01, m02, lx, v0
        ADDNV   [lx], m03, [lx]
        dot_constant px, py, pz, m10, m11, m12, ly, v0
        ADDNV   [ly], m13, [ly]
        dot_constant px, py, pz, m20, m21, m22, lz, v0
        ADDNV   [lz], m23, [lz]
        look_at_points lx, ly, lz
normal_own:
        load_field P_NORMAL, target
        BSAVE   link_kernel, [target]
        IBXEQ   s9, r0, r0, normal_world
        dot_constant nx, ny, nz, m00, m10, m20, lx, v0
        dot_constant nx, ny, nz, m01, m11, m21, ly, v0
        dot_constant nx, ny, nz, m02, m12, m22, lz, v0
        normalise lx, ly, lz, v0, v1
        VTOV    [lx], [nx]
        VTOV    [ly], [ny]
        VTOV    [lz], [nz]
normal_world:
        dot_vectors nx, ny, nz, hdx, hdy, hdz, facing, v0
        CMPLTV  r0, [facing], [hits0]
        VTOV    -[nx], [nx] ? [hits0]
        VTOV    -[ny], [ny] ? [hits0]
        VTOV    -[nz], [nz] ? [hits0]
        VTOV    -[facing], [facing] ? [hits0]
        BIM     0, link_inner

; The pigment's colour.  Checker: the second colour where
; floor(x) + floor(y) + floor(z) is odd, in the pigment's space.
        .macro  pattern_floor x0, x1, x2, k0, k1, k2, k3, sum
        dot_constant \x0, \x1, \x2, \k0, \k1, \k2, v0, v1
        ADDNV   [v0], \k3, [v0]
        ADDNV   [v0], checker_shift, [v0]
        FLRV    [v0], [\sum]
        .endm

find_pigment:
        load_record P_COLOR, 6, color0r
        VTOV    color0r, [cr]
        VTOV    color0g, [cg]
        VTOV    color0b, [cb]
        load_field P_CHECKER, s0
        IBXEQ   s0, r0, r0, pigment_plain
        load_record P_PATTERN, 12, m00
        pattern_floor px, py, pz, m00, m01, m02, m03, v2
        pattern_floor px, py, pz, m10, m11, m12, m13, v3
        pattern_floor px, py, pz, m20, m21, m22, m23, v4
        ADDUV   [v2], [v3], [v2]
        ADDUV   [v2], [v4], [v2]
        ANDV    [v2], one_index, [v2]
        CMPNEV  [v2], r0, [hits0]
        VTOV    color1r, [cr] ? [hits0]
        VTOV    color1g, [cg] ? [hits0]
        VTOV    color1b, [cb] ? [hits0]
pigment_plain:
        BIM     0, link_kernel

; The light of one source added to red, green, blue.  [v5] = N.L, [v6] = D.L.
        .macro  add_light strength, light, channel, bits
        MPYSV   [\strength], \light, [v1]
        ADDNV   [\channel], [v1], [\channel] ? [\bits]
        .endm

        .macro  add_highlight amount
        MPYSV   [v0], \amount, [v0]
        add_light v0, light_r, red, hits0
        add_light v0, light_g, green, hits0
        add_light v0, light_b, blue, hits0
        .endm

        .macro  add_diffuse light, pigment, channel
        MPYSV   [v0], \light, [v1]
        MPYSV   [v1], [\pigment], [v1]
        ADDNV   [\channel], [v1], [\channel] ? [hits3]
        .endm

illuminate:
        RTOR    link_kernel, link_light
        SUBNV   light_x, [px], [lx]
        SUBNV   light_y, [py], [ly]
        SUBNV   light_z, [pz], [lz]
        normalise lx, ly, lz, v0, v1
        dot_vectors nx, ny, nz, lx, ly, lz, v5, v0
        CMPLTV  r0, [v5], [hits3]
        CNTOB   [hits3], s0
        IBXEQ   s0, r0, r0, illuminate_done
        MPYSV   [v5], f_diffuse, [v0]
        add_diffuse light_r, cr, red
        add_diffuse light_g, cg, green
        add_diffuse light_b, cb, blue
        CFPEQ   light_gleams, r0, illuminate_done
        dot_vectors hdx, hdy, hdz, lx, ly, lz, v6, v0
        CFPGE   r0, f_phong, illuminate_no_phong
        MPYSV   [facing], two, [v0]
        MPYSV   [v0], [v5], [v0]
        SUBNV   [v6], [v0], [v0]
        CMPLTV  r0, [v0], [hits0]
        ANDB    [hits0], [hits3], [hits0]
        CNTOB   [hits0], s0
        IBXEQ   s0, r0, r0, illuminate_no_phong
        MASKV   [v0], one, [v0] ? [hits0]
        RTOR    f_size, exponent
        EX      target, power
        BSAVE   link_inner, [target]
        add_highlight f_phong
illuminate_no_phong:
        CFPGE   r0, f_specular, illuminate_done
        LINKV
        MPYSV   [v6], two, [v0]
        SUBNV   two, [v0], [v1]
        SUBNV   [v5], [facing], [v0]
        SQRTV   [v1], [v1] ? [hits3]
        MASKV   [v1], one, [v1] ? [hits3]
        DIVSV   [v0], [v1], [v0]
        CMPLTV  r0, [v0], [hits0]
        ANDB    [hits0], [hits3], [hits0]
        CNTOB   [hits0], s0
        IBXEQ   s0, r0, r0, illuminate_done
        MASKV   [v0], one, [v0] ? [hits0]
        RTOR    f_sharpness, exponent
        EX      target, power
        BSAVE   link_inner, [target]
        add_highlight f_specular
illuminate_done:
        BIM     0, link_light
        .endkernel
