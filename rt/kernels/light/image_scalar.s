; image_scalar.s - computes the colour of an image at a point.  The formulas are
; in image.s, the order of the operations is that of image_vector.s.
; find_pattern calls these routines.  They return the colour in y_0 .. y_2, and
; image_cell for pigment_cell; if that is not 0 there is no colour.

        .share  local
        .regs   r48, row_words, pixel_words, column_at, column_before
        .regs   r52, row_at, row_before, image_u, texel, weight
        .regs   r58, corner_r, corner_g, corner_b, edge_before, edge_after
        .regs   r63, weight_sum
        .endshare

; y_0 = the pattern radial of x, z.
        .macro  find_turn
        EX      target, pattern_radial
        BSAVE   inner_link, [target]
        .endm

        .macro  axis_distance to
        MPYS    q_x, q_x, y_0
        MPYS    q_z, q_z, y_1
        ADDN    y_1, y_0, y_0
        SQRT    y_0, \to
        .endm

; Compute the weight from q_x, q_y.  weigh_by_distance changes y_3 and adds to
; weight_sum.
        .macro  weigh_bilinear
        MPYS    q_x, q_y, weight
        .endm

        .macro  weigh_by_distance
        SUBN    m_one, q_x, y_3
        MPYS    y_3, y_3, weight
        SUBN    m_one, q_y, y_3
        MPYS    y_3, y_3, y_3
        ADDN    weight, y_3, weight
        ADDN    weight, m_tiny, weight
        DIVS    m_one, weight, weight
        ADDN    weight_sum, weight, weight_sum
        .endm

; Adds the pixel of column and row, times its weight.
        .macro  add_corner weigh, column, row
        \weigh
        ADDX    \row, \column, texel
        SHIFTI  texel, 6, texel
        ADDX    map_stops, texel, texel
        ELEN    texel, PIXEL_SIZE
        SWAP    [texel], corner_r, [r0]
        MPYS    corner_r, weight, corner_r
        MPYS    corner_g, weight, corner_g
        MPYS    corner_b, weight, corner_b
        ADDN    y_0, corner_r, y_0
        ADDN    y_1, corner_g, y_1
        ADDN    y_2, corner_b, y_2
        .endm

; For x, measured in count pixels: at = floor(x + 1/2), before = at - 1, both
; within the image and times words; x := x + 1/2 - floor(x + 1/2).  Changes y_3,
; y_4.
        .macro  find_neighbours x, count, words, at, before
        ADDN    \x, m_half, \x
        FLR     \x, \at
        ADDN    \at, r0, y_3
        SUBN    \x, y_3, \x
        ADDX    \at, m_index_minus_one, \before
        FLR     \count, y_4
        ADDX    y_4, m_index_minus_one, y_4
        ES      edge_after, 0
        RTOR    y_4, edge_before
        CFPEQ   map_d, r0, neighbours_repeated\@
        RTOR    y_4, edge_after
        ES      edge_before, 0
neighbours_repeated\@:
        CFPNE   y_3, \count, neighbours_within\@
        RTOR    edge_after, \at
neighbours_within\@:
        CFPNE   y_3, r0, neighbours_found\@
        RTOR    edge_before, \before
neighbours_found\@:
        MPYL    \at, \words, \at
        MPYL    \before, \words, \before
        .endm

; Sums the four pixels; q_x, q_y become p, q.
        .macro  add_four weigh
        find_neighbours q_x, map_a, pixel_words, column_at, column_before
        find_neighbours q_y, map_b, row_words, row_at, row_before
        RTOR    m_zero, y_0
        RTOR    m_zero, y_1
        RTOR    m_zero, y_2
        RTOR    m_zero, weight_sum
        add_corner \weigh, column_at, row_at
        SUBN    m_one, q_x, q_x
        add_corner \weigh, column_before, row_at
        SUBN    m_one, q_y, q_y
        add_corner \weigh, column_before, row_before
        SUBN    m_one, q_x, q_x
        add_corner \weigh, column_at, row_before
        .endm

        .kernel shade
; Computes the cell of the primitive's image, for pigment_cell, which calls it
; by BSAVE image_link.
find_image_cell:
        get_record P_PATTERN, 12, sh0
        get_record P_MAP, MAP_SIZE, map_function
        pattern_colour
        RTOR    image_cell, cell
        BIM     0, image_link

image_spherical:
        find_turn
        SUBN    m_one, y_0, image_u
        axis_distance q_z
        RTOR    q_y, q_x
        find_turn
        MPYS    y_0, m_two, q_y
        SUBN    q_y, m_one, q_y
        RTOR    image_u, q_x
        BIM     image_planar
image_cylindrical:
        find_turn
        SUBN    m_one, y_0, q_x
        BIM     image_planar
image_torus:
        find_turn
        SUBN    m_one, y_0, image_u
        axis_distance q_x
        SUBN    m_one, q_x, q_x
        SUBN    r0, q_y, q_z
        find_turn
        SUBN    m_one, y_0, q_y
        RTOR    image_u, q_x

; In: q_x, q_y = u, v.
image_planar:
        ADDN    q_x, m_checker_shift, q_x
        ADDN    q_y, m_checker_shift, q_y
        SUBN    r0, q_y, q_y
        FLR     q_x, y_0
        ADDN    y_0, r0, y_0
        FLR     q_y, y_1
        ADDN    y_1, r0, y_1
        SUBN    q_x, y_0, q_x
        SUBN    q_y, y_1, q_y
        CFPEQ   map_c, r0, image_place
        CFPNE   y_1, m_minus_one, image_outside
        CFPNE   map_c, m_two, image_place
        CFPNE   y_0, r0, image_outside
image_place:
        MPYS    q_x, map_a, q_x                 ; c
        MPYS    q_y, map_b, q_y                 ; d
        ES      pixel_words, PIXEL_SIZE
        FLR     map_a, row_words
        MPYL    row_words, pixel_words, row_words
        BIM     0, map_wave
image_outside:
        ES      image_cell, 256
        BIM     0, pattern_link

image_nearest:
        FLR     q_x, y_0
        FLR     q_y, y_1
        MPYL    y_0, pixel_words, y_0
        MPYL    y_1, row_words, y_1
        ADDX    y_1, y_0, texel
        AND     texel, p_fraction, texel        ; y_1 may be a machine zero
        SHIFTI  texel, 6, texel
        ADDX    map_stops, texel, texel
        ELEN    texel, PIXEL_SIZE
        SWAP    [texel], y_0, [r0]
        BIM     0, pattern_link

image_bilinear:
        add_four weigh_bilinear
        BIM     0, pattern_link
image_by_distance:
        add_four weigh_by_distance
        DIVS    m_one, weight_sum, weight_sum
        MPYS    y_0, weight_sum, y_0
        MPYS    y_1, weight_sum, y_1
        MPYS    y_2, weight_sum, y_2
        BIM     0, pattern_link
        .endkernel
