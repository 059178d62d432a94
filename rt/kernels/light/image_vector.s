; image_vector.s - computes the colours of images at m points.  The formulas are
; in image.s.
;
; In:  v5 v6 v7 = x, y, z; map_function .. = P_MAP; link_pattern.
; Out: cr cg cb.  Changes v0-v7, red, green, blue, hits1-hits3, s0-s9.

        .share
        .regs   r7, row_words, pixel_words, edge_before, edge_after, last_column
        .endshare

; [v0] = the pattern radial of x, z.
        .macro  find_turn
        EX      target, pattern_radial
        BSAVE   link_inner, [target]
        .endm

; [to] = sqrt(x^2 + z^2).
        .macro  axis_distance to
        MPYSV   [v5], [v5], [v0]
        MPYSV   [v7], [v7], [v1]
        ADDNV   [v1], [v0], [v0]
        SQRTV   [v0], [\to]
        .endm

; Changes the coordinates u, v: v points down.  Computes the floors of both, as
; numbers.
        .macro  find_tile u, v, u_floor, v_floor
        ADDNV   [\u], checker_shift, [\u]
        ADDNV   [\v], checker_shift, [\v]
        VTOV    -[\v], [\v]
        FLRV    [\u], [\u_floor]
        ADDNV   [\u_floor], r0, [\u_floor]
        FLRV    [\v], [\v_floor]
        ADDNV   [\v_floor], r0, [\v_floor]
        .endm

; [hits3] = the points outside the image, by bound, which is not 0.
        .macro  find_outside bound, u_floor, v_floor
        CMPNEV  [\v_floor], minus_one, [hits3]
        CFPNE   \bound, two, outside_found\@
        CMPNEV  [\u_floor], r0, [hits1]
        ORB     [hits1], [hits3], [hits3]
outside_found\@:
        .endm

; Adds one channel of the pixels [v4].
        .macro  add_pixel color
        VXTOV   [v4], [s0], [red]
        MPYSV   [red], [v7], [red]
        ADDNV   [\color], [red], [\color]
        IX      s0, 64
        .endm

; Compute the weight [v7] from v5, v6.  weigh_by_distance changes v4 and adds to
; the sum [blue].
        .macro  weigh_bilinear
        MPYSV   [v5], [v6], [v7]
        .endm

        .macro  weigh_by_distance
        SUBNV   one, [v5], [v4]
        MPYSV   [v4], [v4], [v7]
        SUBNV   one, [v6], [v4]
        MPYSV   [v4], [v4], [v4]
        ADDNV   [v7], [v4], [v7]
        ADDNV   [v7], tiny, [v7]
        DIVSV   one, [v7], [v7]
        ADDNV   [blue], [v7], [blue]
        .endm

; Adds the pixels of column and row, times their weight.
        .macro  add_corner weigh, column, row
        \weigh
        ADDXV   [\row], [\column], [v4]
        RTOR    map_stops, s0
        add_pixel cr
        add_pixel cg
        add_pixel cb
        .endm

; For [x], measured in count pixels: [at] = floor(x + 1/2), [before] = at - 1,
; both within the image and times words; [x] := x + 1/2 - floor(x + 1/2).
; Changes v4.
        .macro  find_neighbours x, count, words, at, before
        ADDNV   [\x], half, [\x]
        FLRV    [\x], [\at]
        ADDNV   [\at], r0, [v4]
        SUBNV   [\x], [v4], [\x]
        ADDXV   [\at], minus_one_index, [\before]
        FLR     \count, last_column
        ADDX    last_column, minus_one_index, last_column
        ES      edge_after, 0
        RTOR    last_column, edge_before
        CFPEQ   map_d, r0, neighbours_repeated\@
        RTOR    last_column, edge_after
        ES      edge_before, 0
neighbours_repeated\@:
        CMPEQV  [v4], \count, [hits1]
        VTOV    edge_after, [\at] ? [hits1]
        CMPEQV  [v4], r0, [hits1]
        VTOV    edge_before, [\before] ? [hits1]
        MPYLV   [\at], \words, [\at]
        MPYLV   [\before], \words, [\before]
        .endm

; Sums the four pixels: v0, v3 = the columns at and before, v1, v2 = the rows;
; v5, v6 become p, q.
        .macro  add_four weigh
        find_neighbours v5, map_a, pixel_words, v0, v3
        find_neighbours v6, map_b, row_words, v1, v2
        VTOV    r0, [cr]
        VTOV    r0, [cg]
        VTOV    r0, [cb]
        VTOV    r0, [blue]
        add_corner \weigh, v0, v1
        SUBNV   one, [v5], [v5]
        add_corner \weigh, v3, v1
        SUBNV   one, [v6], [v6]
        add_corner \weigh, v3, v2
        SUBNV   one, [v5], [v5]
        add_corner \weigh, v0, v2
        .endm

        .kernel shade
; In: px py pz; the primitive's record.  Out: hits3 = the points in the second
; cell of its pigment, a checker or a bounded image.  Changes v0-v4, hits1.
find_cells:
        load_field P_PIGMENT, s0
        IBXEQ   s0, r0, one_index, find_checker
        load_record P_PATTERN, 8, m00
        pattern_axis m00, m01, m02, m03, v1
        pattern_axis m10, m11, m12, m13, v2
        find_tile v1, v2, v3, v4
        load_field P_MAP_NUMBERS + 2, s0
        find_outside s0, v3, v4
        BIM     0, link_inner

image_spherical:
        find_turn
        SUBNV   one, [v0], [cr]
        axis_distance v7
        VTOV    [v6], [v5]
        find_turn
        LINKV
        MPYSV   [v0], two, [v6]
        SUBNV   [v6], one, [v6]
        VTOV    [cr], [v5]
        BIM     image_planar
image_cylindrical:
        find_turn
        SUBNV   one, [v0], [v5]
        BIM     image_planar
image_torus:
        find_turn
        SUBNV   one, [v0], [cr]
        axis_distance v5
        SUBNV   one, [v5], [v5]
        VTOV    -[v6], [v7]
        find_turn
        SUBNV   one, [v0], [v6]
        VTOV    [cr], [v5]

; In: v5 v6 = u, v.
image_planar:
        find_tile v5, v6, v0, v1
        SUBNV   [v5], [v0], [v5]
        SUBNV   [v6], [v1], [v6]
        CFPEQ   map_c, r0, image_place
        find_outside map_c, v0, v1
image_place:
        MPYSV   [v5], map_a, [v5]               ; c
        MPYSV   [v6], map_b, [v6]               ; d
        ES      pixel_words, PIXEL_SIZE
        FLR     map_a, row_words
        MPYL    row_words, pixel_words, row_words
        RTOR    map_wave, target
        BSAVE   link_inner, [target]
        CFPEQ   map_c, r0, image_found
        load_record P_COLOR + 3, 3, s1
        VTOV    s1, [cr] ? [hits3]
        VTOV    s2, [cg] ? [hits3]
        VTOV    s3, [cb] ? [hits3]
image_found:
        BIM     0, link_pattern

image_nearest:
        FLRV    [v5], [v0]
        FLRV    [v6], [v1]
        MPYLV   [v0], pixel_words, [v0]
        MPYLV   [v1], row_words, [v1]
        ADDXV   [v1], [v0], [v0]
        RTOR    map_stops, s0
        VXTOV   [v0], [s0], [cr]
        IX      s0, 64
        VXTOV   [v0], [s0], [cg]
        IX      s0, 64
        VXTOV   [v0], [s0], [cb]
        BIM     0, link_inner

image_bilinear:
        add_four weigh_bilinear
        BIM     0, link_inner
image_by_distance:
        add_four weigh_by_distance
        DIVSV   one, [blue], [blue]
        MPYSV   [cr], [blue], [cr]
        MPYSV   [cg], [blue], [cg]
        MPYSV   [cb], [blue], [cb]
        BIM     0, link_inner
        .endkernel
