; surface_vector.s - computes the normals of surfaces at the hits of rays.
;
; A point is transformed to the space of the shape.  The normal there is
; transformed back by the transpose of the same matrix, and normalised.
;
; set_hits:    In: h.  Out: the vectors of all hits, of length h.
; set_part:    In: part_at, a part of the hits.  Out: primitive, m; the
;   vectors of the part.
; find_normal: In: part_at, primitive; at, [px] [py] [pz] [hdx] [hdy] [hdz], of
;   the length of the part.  Out: [nx] [ny] [nz], [facing], hits0.
; Source: textbook.

        .include "light/pigment.s"

        .kernel shade
; Describes the vectors of all hits.
set_hits:
        set_lengths h, m_high, shade_bases, shade_descriptors, SHADE_VECTORS, at
        describe ndotl, NDOTL_STORE, h
        BIM     0, link_inner

; Describes the vectors of the part at part_at: slices of the kept vectors of
; all hits; the other vectors from their beginning on.
set_part:
        RTOR    part_at, s0
        load_from s0, PART_SIZE, s1
        RTOR    s1, primitive
        SHIFTI  s2, 6, part_offset
        RTOR    s3, m
        SHIFTI  m, 48, m_high
        ADDX    m_high, part_offset, s4
        EX      s0, shade_bases
        ELEN    s0, HIT_VECTORS
        EX      s1, shade_descriptors
        ELEN    s1, HIT_VECTORS
        ADDXV   s4, [s0], [s1]
        IX      s0, 64 * HIT_VECTORS
        ELEN    s0, SHADE_VECTORS - HIT_VECTORS
        IX      s1, 64 * HIT_VECTORS
        ELEN    s1, SHADE_VECTORS - HIT_VECTORS
        ORV     [s0], m_high, [s1]
        load_words shade_descriptors, SHADE_VECTORS, at, shape_at
        describe ndotl, NDOTL_STORE, m
        ADDX    ndotl, part_offset, ndotl
        BIM     0, link_inner

; Computes the world normals at the points, turned against the rays; facing = N
; . D.  hits0 = the normals that were turned, or, with bumps, those that did not
; face the ray; then normal and facing include the bumps.
find_normal:
        RTOR    link_kernel, link_inner
        set_points px, py, pz
        load_field P_TRANSFORMED, s9
        load_of part_at, PART_SHARED, s0
        IBXNE   s0, r0, r0, normal_shared
        IBXEQ   s9, r0, r0, normal_local
        load_record P_LOCAL, 12, m00
        local_coordinate m00, m01, m02, m03, lx
        local_coordinate m10, m11, m12, m13, ly
        local_coordinate m20, m21, m22, m23, lz
        set_points lx, ly, lz
normal_local:
        load_field P_NORMAL, target
        BSAVE   link_kernel, [target]
        IBXEQ   s9, r0, r0, normal_world
        dot_constant nx, ny, nz, m00, m10, m20, lx, v0
        dot_constant nx, ny, nz, m01, m11, m21, ly, v0
        dot_constant nx, ny, nz, m02, m12, m22, lz, v0
        normalise lx, ly, lz, v0, v1
        copy_three [lx], [ly], [lz], [nx], [ny], [nz], VTOV
normal_world:
        dot_vectors nx, ny, nz, hdx, hdy, hdz, facing, v0
        CMPLTV  r0, [facing], [hits0]
        if_none hits0, s0, normal_faces
        VTOV    -[nx], [nx] ? [hits0]
        VTOV    -[ny], [ny] ? [hits0]
        VTOV    -[nz], [nz] ? [hits0]
        VTOV    -[facing], [facing] ? [hits0]
normal_faces:
        .if     MESH_CROSSINGS
        load_field P_ON_PATCH, s0
        ES      s1, 2
        IBXNE   s0, r0, s1, normal_sided
        VXTOV   [at], [hit_t], [v0]             ; a mesh has no outside
        CMPNEV  [v0], r0, [hits0]
normal_sided:
        .endif
        .if     BUMPS
        CMPLTV  [facing], r0, [hits1]
        ORNB    [hits0], [hits1], [hits0]
        load_field P_BUMP, bump_at
        IBXNE   bump_at, r0, r0, bumped
        .endif
        BIM     0, link_inner

; Spheres of one material: as normal_sphere, with a centre for each hit.
normal_shared:
        VXTOV   [at], [nearest_primitive], [v1]
        find_records v1, v1, P_SHAPE, s1
        VXTOV   [v1], [s1], [lx]
        IX      s1, 64
        VXTOV   [v1], [s1], [ly]
        IX      s1, 64
        VXTOV   [v1], [s1], [lz]
        IX      s1, 64 * 2
        VXTOV   [v1], [s1], [v2]
        SUBNV   [px], [lx], [nx]
        MPYSV   [nx], [v2], [nx]
        SUBNV   [py], [ly], [ny]
        MPYSV   [ny], [v2], [ny]
        SUBNV   [pz], [lz], [nz]
        MPYSV   [nz], [v2], [nz]
        BIM     normal_world
        .endkernel
