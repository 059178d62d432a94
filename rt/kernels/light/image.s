; image.s - pigments that are images, in both forms (IMAGES = 1, and PATTERNS).
;
; An image extends from 0 to 1 along u and along v, which points up.  A point x,
; y, z of the pigment's space has the coordinates
;
;   planar       u = x,        v = y
;   spherical    u = t(x, z),  v = 1/2 + 2 (angle of the point above y = 0)
;   cylindrical  u = t(x, z),  v = y
;   torus        u = t(x, z),  v = t(1 - r, -y),   r = sqrt(x^2 + z^2)
;
; where t(a, b) is the angle from a towards b.  All angles are in turns and
; computed by the routine of the radial pattern (pattern.s).  Let {c} =
; c - floor(c), which is below 1 because differences are truncated, and
; e = k_checker.  In an image of W columns and H rows, row 0 at the top, the
; point is in
;
;   column c = W {u + e},   row d = H {-(v + e)}
;
; If the image is shown once, some points are outside of it: for a planar image
; those whose u + e or v + e is not in 0 .. 1, for a cylindrical image those
; whose v + e is not.  Their colour is the second one of P_COLOR, as in a
; checker's odd cell.  The colour of all other points is
;
;   nearest      that of the pixel floor(c), floor(d)
;   bilinear     with i = floor(c + 1/2), p = c + 1/2 - i, and j, q for d,
;                p q of the pixel i, j, and (1-p) q of i-1, j, p (1-q) of i,
;                j-1, (1-p) (1-q) of i-1, j-1
;   by distance  of the same four 1 / ((1-p)^2 + (1-q)^2 + k_tiny), with p
;                instead of 1-p for i-1, q for j-1; divided by their sum
;
; The neighbour of the last column is the first column, and the reverse.  If the
; image is shown once, a column at an edge is its own neighbour.  The same
; applies to rows.
; Source: POV-Ray 3.7's image maps, verified by its pictures.
;
; P_MAP contains the address of the routine for the coordinates, the address of
; the routine for the colour, the numbers W and H, the test for points outside
; (0: none, 1: v, 2: u and v), 1 if the image is shown once, and the address of
; the pixels (red, green, blue, row by row).  It has no stops.
        .equ    PIXEL_SIZE, 3

; y_0 = the pattern radial of x, z.
        .macro  find_turn
        call_routine pattern_radial, inner_link
        .endm

        .macro  axis_distance to
        times   q_x, q_x, y_0
        times   q_z, q_z, y_1
        plus    y_1, y_0, y_0
        root    y_0, \to
        .endm

; Changes the coordinates u, v: v points down.  Computes the floors of both, as
; numbers.
        .macro  find_tile u, v, u_floor, v_floor
        raise   \u, m_checker_shift, \u
        raise   \v, m_checker_shift, \v
        negate  \v, \v
        floor   \u, \u_floor
        normal  \u_floor, \u_floor
        floor   \v, \v_floor
        normal  \v_floor, \v_floor
        .endm

; Compute the weight from q_x, q_y.  weigh_by_distance also adds it to
; weight_sum.
        .macro  weigh_bilinear
        times   q_x, q_y, weight
        .endm

        .macro  weigh_by_distance
        from    m_one, q_x, image_work
        times   image_work, image_work, weight
        from    m_one, q_y, image_work
        times   image_work, image_work, image_work
        plus    weight, image_work, weight
        raise   weight, m_tiny, weight
        into    m_one, weight, weight
        plus    weight_sum, weight, weight_sum
        .endm

; Adds the pixel of column and row, times its weight.
        .macro  add_corner weigh, column, row
        \weigh
        plus_index \row, \column, texel
        add_pixel
        .endm

; For x, measured in count pixels: at = floor(x + 1/2), before = at - 1, both
; within the image and times words; x := x + 1/2 - floor(x + 1/2).
        .macro  find_neighbours x, count, words, at, before
        raise   \x, m_half, \x
        floor   \x, \at
        normal  \at, image_work
        minus   \x, image_work, \x
        raise_index \at, m_index_minus_one, \before
        FLR     \count, last_column
        ADDX    last_column, m_index_minus_one, last_column
        ES      edge_after, 0
        RTOR    last_column, edge_before
        CFPEQ   map_d, r0, neighbours_repeated\@
        RTOR    last_column, edge_after
        ES      edge_before, 0
neighbours_repeated\@:
        if_equal_number image_work, \count, neighbours_within\@
        then_set edge_after, \at
        end_if  neighbours_within\@
        if_equal_number image_work, r0, neighbours_found\@
        then_set edge_before, \before
        end_if  neighbours_found\@
        low_product_number \at, \words, \at
        low_product_number \before, \words, \before
        .endm

; Sums the four pixels; q_x, q_y become p, q.
        .macro  add_four weigh
        find_neighbours q_x, map_a, pixel_words, column_at, column_before
        find_neighbours q_y, map_b, row_words, row_at, row_before
        set     m_zero, image_r
        set     m_zero, image_g
        set     m_zero, image_b
        set     m_zero, weight_sum
        add_corner \weigh, column_at, row_at
        from    m_one, q_x, q_x
        add_corner \weigh, column_before, row_at
        from    m_one, q_y, q_y
        add_corner \weigh, column_before, row_before
        from    m_one, q_x, q_x
        add_corner \weigh, column_at, row_before
        .endm

        .kernel shade
        begin_image

image_spherical:
        find_turn
        from    m_one, y_0, image_u
        axis_distance q_z
        copy    q_y, q_x
        find_turn
        line    y_0, m_two, m_minus_one, q_y
        copy    image_u, q_x
        BIM     image_planar
image_cylindrical:
        find_turn
        from    m_one, y_0, q_x
        BIM     image_planar
image_torus:
        find_turn
        from    m_one, y_0, image_u
        axis_distance q_x
        from    m_one, q_x, q_x
        negate  q_y, q_z
        find_turn
        from    m_one, y_0, q_y
        copy    image_u, q_x

; In: q_x, q_y = u, v.
image_planar:
        find_tile q_x, q_y, y_0, y_1
        minus   q_x, y_0, q_x
        minus   q_y, y_1, q_y
        CFPEQ   map_c, r0, image_place
        find_outside map_c, y_0, y_1, image_place
image_place:
        scale   q_x, map_a, q_x                 ; c
        scale   q_y, map_b, q_y                 ; d
        ES      pixel_words, PIXEL_SIZE
        FLR     map_a, row_words
        MPYL    row_words, pixel_words, row_words
        find_colour

image_nearest:
        floor   q_x, y_0
        floor   q_y, y_1
        low_product_number y_0, pixel_words, y_0
        low_product_number y_1, row_words, y_1
        plus_index y_1, y_0, texel
        load_pixel
        BIM     0, colour_link

image_bilinear:
        add_four weigh_bilinear
        BIM     0, colour_link
image_by_distance:
        add_four weigh_by_distance
        into    m_one, weight_sum, weight_sum
        three_by times, weight_sum, image_r, image_g, image_b, image_r, image_g, image_b
        BIM     0, colour_link
        .endkernel
