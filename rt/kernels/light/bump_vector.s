; bump_vector.s - computes normals with bumps at the m points of a part of the
; hits.  The formulas are in bump.s.

        .share  scratch
        .regs   r234, bump_outer, bump_left, bump_corner, bump_corners_left
        .regs   r250, link_bump, link_height
        .endshare

        .data
        .align  64
bump_normals:   .space 3 * QUEUE        ; normals of a part without bumps
bump_bits:      .space 2 * QUEUE_BIT_WORDS
        .code

        .macro  load_bump offset, number, first
        RTOR    bump_at, s0
        IX      s0, 64 * (\offset)
        ELEN    s0, \number
        SWAP    [s0], \first, [r0]
        .endm

        .macro  load_bump_field offset, register
        RTOR    bump_at, s0
        IX      s0, 64 * (\offset)
        LOD     [s0], \register
        .endm

; Describes the normals of the part without bumps.
        .macro  normals_before x0, x1, x2
        describe \x0, bump_normals, m
        describe \x1, bump_normals + 64 * QUEUE, m
        describe \x2, bump_normals + 64 * QUEUE * 2, m
        .endm

        .macro  bump_row row0, row1, row2, x0, x1, x2, to
        dot_constant \x0, \x1, \x2, \row0, \row1, \row2, \to, v0
        .endm

; Computes the three products with the nine words that load_bump loaded from m00
; on.
        .macro  bump_rows x0, x1, x2, y0, y1, y2
        bump_row m00, m01, m02, \x0, \x1, \x2, \y0
        bump_row m03, m10, m11, \x0, \x1, \x2, \y1
        bump_row m12, m13, m20, \x0, \x1, \x2, \y2
        .endm

        .macro  bump_axis k0, k1, k2, k3, q
        dot_constant px, py, pz, \k0, \k1, \k2, \q, v0
        ADDNV   [\q], \k3, [\q]
        .endm

        .macro  bump_place x, y, z
        load_bump BUMP_TO_LOCAL, 12, m00
        bump_axis m00, m01, m02, m03, \x
        bump_axis m10, m11, m12, m13, \y
        bump_axis m20, m21, m22, m23, \z
        .endm

        .macro  bump_push normal, by
        LINKV
        MPYSV   [v0], \by, [v1]
        ADDNV   [v1], [\normal], [\normal]
        .endm

; [v] = the position of [q] in its unit cube, relative to its centre.
        .macro  quilt_place q, v
        VTOV    [\q], [\v]
        less_floor \v, v0
        SUBNV   [\v], half, [\v]
        .endm

        .macro  quilt_push v, normal
        MPYSV   [v1], [\v], [v2]
        ADDNV   [v2], [\normal], [\normal]
        .endm

; bump_upper adds the share ndotl of [x] to [sum] in hits1; bump_lower sets
; [sum] to the share v0 of [x] in hits2.
        .macro  bump_upper x, sum
        MPYSV   [\x], [ndotl], [v1]
        ADDNV   [\sum], [v1], [\sum] ? [hits1]
        .endm

        .macro  bump_lower x, sum
        MPYSV   [\x], [v0], [v1]
        VTOV    [v1], [\sum] ? [hits2]
        .endm

        .macro  bump_weigh x, sum
        LINKV
        MPYSV   [\x], s1, [v1]
        ADDNV   [v1], [\sum], [\sum]
        .endm

        .macro  turn_back before, v
        MPYSV   [v4], [\before], [v6]
        SUBNV   [\v], [v6], [\v] ? [s7]
        .endm

        .kernel spawn
; Corrects reflected directions v1 v2 v3 that would go behind the surface of a
; part with bumps.  Changes v4, v6; called by BSAVE link_kernel.
mirror_outside:
        load_field P_BUMP, s0
        IBXEQ   s0, r0, r0, mirror_is_outside
        normals_before s4, s5, s6
        describe s7, bump_bits, m
        describe s8, bump_bits + 64 * QUEUE_BIT_WORDS, m
        dot_vectors v1, v2, v3, s4, s5, s6, v4, v6
        CMPLTV  [v4], r0, [s7]
        dot_vectors v1, v2, v3, nx, ny, nz, v4, v6
        CMPLTV  [v4], r0, [s8]
        ANDB    [s7], [s8], [s8]
        VTOV    [hdx], [v1] ? [s8]
        VTOV    [hdy], [v2] ? [s8]
        VTOV    [hdz], [v3] ? [s8]
        dot_vectors v1, v2, v3, s4, s5, s6, v4, v6
        MPYSV   [v4], two, [v4]
        turn_back s4, v1
        turn_back s5, v2
        turn_back s6, v3
mirror_is_outside:
        BIM     0, link_kernel

; Changes the sign of the root v7 for rays that see the back of the normal.
refract_from_back:
        describe s7, bump_bits, m
        CMPLTV  r0, [facing], [s7]
        VTOV    -[v7], [v7] ? [s7]
        BIM     0, link_kernel
        .endkernel

        .kernel shade
; Applies the primitive's bumps, bump_at, to nx, ny, nz and facing.  Keeps
; hits0.  Changes v0-v7, hits1-hits3, lx .., cr .., red .., ndotl.
bumped:
        RTOR    link_inner, link_bump
        normals_before s1, s2, s3
        VTOV    [nx], [s1]
        VTOV    [ny], [s2]
        VTOV    [nz], [s3]
        load_bump_field BUMP_ENTRY_COUNT, bump_left
        IBXNE   bump_left, r0, r0, bumped_by_map
        EX      target, find_bump
        BSAVE   link_kernel, [target]
bumped_found:
        VTOV    [lx], [nx]
        VTOV    [ly], [ny]
        VTOV    [lz], [nz]
        dot_vectors nx, ny, nz, hdx, hdy, hdz, facing, v0
        BIM     0, link_bump

; facing = the values of the map's pattern.  Then, entry by entry: cr, cg, cb =
; the sum, ndotl = the share of the upper entry.
bumped_by_map:
        RTOR    bump_at, bump_outer
        load_bump BUMP_MAP, MAP_SIZE, map_function
        IBXEQ   map_function, r0, r0, bumped_by_all
        bump_place v5, v6, v7
        EX      target, find_height
        BSAVE   link_height, [target]
        VTOV    [v0], [facing]
        load_bump_field BUMP_ENTRIES, bump_at
bumped_entry:
        EX      target, find_bump
        BSAVE   link_kernel, [target]
        load_bump BUMP_FROM, 4, m00             ; also to, low, rise
        CFPGE   m00, big, bumped_lower          ; the first entry
        CMPGEV  [facing], m00, [hits1]
        CMPLTV  [facing], m01, [hits2]
        ANDB    [hits1], [hits2], [hits1]
        bump_upper lx, cr
        bump_upper ly, cg
        bump_upper lz, cb
        CFPGE   m01, big, bumped_next           ; the last entry
bumped_lower:
        CMPGEV  [facing], m01, [hits2]
        LINKV
        SUBNV   [facing], m02, [v0]
        MPYSV   [v0], m03, [v0]
        CMPLTV  [v0], r0, [hits1]
        VTOV    r0, [v0] ? [hits1]
        CMPLTV  one, [v0], [hits1]
        VTOV    one, [v0] ? [hits1]
        VTOV    [v0], [ndotl]
        SUBNV   one, [v0], [v0]
        bump_lower lx, cr
        bump_lower ly, cg
        bump_lower lz, cb
bumped_next:
        IX      bump_at, 64 * BUMP_SIZE
        IBXNE   bump_left, minus_one_index, r0, bumped_entry, bump_left
bumped_summed:
        RTOR    bump_outer, bump_at
        load_bump BUMP_BACK, 9, m00
        bump_rows cr, cg, cb, lx, ly, lz
        normalise lx, ly, lz, v0, v1
        BIM     bumped_found

bumped_by_all:
        load_bump_field BUMP_ENTRIES, bump_at
        VTOV    r0, [cr]
        VTOV    r0, [cg]
        VTOV    r0, [cb]
bumped_each:
        EX      target, find_bump
        BSAVE   link_kernel, [target]
        load_bump_field BUMP_RISE, s1
        bump_weigh lx, cr
        bump_weigh ly, cg
        bump_weigh lz, cb
        IX      bump_at, 64 * BUMP_SIZE
        IBXNE   bump_left, minus_one_index, r0, bumped_each, bump_left
        BIM     bumped_summed

; lx, ly, lz = the normals by the bump in bump_at, in the space of its map.
find_bump:
        bump_place red, green, blue
        load_bump BUMP_TRANSFORM, 9, m00
        bump_rows nx, ny, nz, lx, ly, lz
        load_bump_field BUMP_SCALED, s1
        IBXEQ   s1, r0, r0, bump_unscaled
        normalise lx, ly, lz, v0, v1
bump_unscaled:
        load_bump BUMP_MAP, MAP_SIZE, map_function
        IBXEQ   map_function, r0, r0, bump_quilted
        RTOR    bump_at, bump_corner
        IX      bump_corner, 64 * BUMP_CORNERS
        ES      bump_corners_left, 4
bump_next:
        ELEN    bump_corner, BUMP_CORNER_SIZE
        SWAP    [bump_corner], m00, [r0]
        ADDNV   [red], m00, [v5]
        ADDNV   [green], m01, [v6]
        ADDNV   [blue], m02, [v7]
        EX      target, find_height
        BSAVE   link_height, [target]
        bump_push lx, m03
        bump_push ly, m10
        bump_push lz, m11
        IX      bump_corner, 64 * BUMP_CORNER_SIZE
        IBXNE   bump_corners_left, minus_one_index, r0, bump_next, bump_corners_left
bump_back:
        load_bump BUMP_BACK, 9, m00
        bump_rows lx, ly, lz, v5, v6, v7
        load_bump_field BUMP_NORMALISED, s1
        IBXEQ   s1, r0, r0, bump_returned
        normalise v5, v6, v7, v0, v1
bump_returned:
        VTOV    [v5], [lx]
        VTOV    [v6], [ly]
        VTOV    [v7], [lz]
        BIM     0, link_kernel

bump_quilted:
        load_bump BUMP_CORNERS, 3, m00
        quilt_place red, v5
        quilt_place green, v6
        quilt_place blue, v7
        dot_vectors v5, v6, v7, v5, v6, v7, v0, v1
        SQRTV   [v0], [v0]
        LINKV
        MPYSV   [v0], m02, [v1]
        ADDNV   [v1], m01, [v1]
        MPYSV   [v1], [v0], [v1]
        LINKV
        ADDNV   [v1], m00, [v1]
        MPYSV   [v1], [v0], [v1]
        quilt_push v5, lx
        quilt_push v6, ly
        quilt_push v7, lz
        BIM     bump_back

; [v0] = the heights at v5 v6 v7, by map_function .. and the bump's map.
; Changes v1-v7, hits1-hits3; called by BSAVE link_height.
find_height:
        EX      target, find_value
        BSAVE   link_pattern, [target]
        load_bump_field BUMP_HEIGHTS, s9
        IBXEQ   s9, r0, r0, height_found
        ELEN    s9, HEIGHT_SIZE
        SWAP    [s9], sh0, [r0]
        VTOV    sh2, [v3]
height_next:
        IX      s9, 64 * HEIGHT_SIZE
        ELEN    s9, HEIGHT_SIZE
        SWAP    [s9], sh0, [r0]
        CFPGE   sh0, big, height_last
        CMPGEV  [v0], sh0, [hits1]
        LINKV
        SUBNV   [v0], sh0, [v1]
        MPYSV   [v1], sh1, [v1]
        LINKV
        MPYSV   [v1], sh5, [v2]
        ADDNV   [v2], sh4, [v2]
        MPYSV   [v2], [v1], [v2]
        LINKV
        ADDNV   [v2], sh3, [v2]
        MPYSV   [v2], [v1], [v2]
        ADDNV   [v2], sh2, [v3] ? [hits1]
        BIM     height_next
height_last:
        VTOV    [v3], [v0]
height_found:
        BIM     0, link_height
        .endkernel
