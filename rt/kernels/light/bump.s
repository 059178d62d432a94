; bump.s - normals that a pattern changes, in both forms (BUMPS = 1).
;
; A pattern (pattern.s) has a height at each point Q of its space: its value,
; the index of the colour in a list of colours, or the value of a map of
; heights.  Between two entries of such a map, with heights h, k and slopes
; s, t, the height is
;
;   h + s u - (2 s + t + 3 (h - k)) u^2 + (s + t + 2 (h - k)) u^3,  0 <= u <= 1.
;
; Before the first entry the height is that of the first one, after the last
; entry that of the last one.
;
; The corners of a tetrahedron are
;
;   c0 = (r, -1/3, 0),  c1, c2 = (-r/2, -1/3, +- sqrt(2/3)),  c3 = (0, 1, 0)
;
; with r = sqrt(8) / 3.  X = M Q is the point in the world, Q = L X, and N is
; the normal there, turned against the ray:
;
;   N' = M^T N, of length one
;   N' = N' + push (height(Q + a c0) c0 + .. + height(Q + a c3) c3)
;   N  = L^T N', of length one
;
; a = accuracy, push = -5 amount 0.02 / a.  If not scaled, N' keeps its length.
;
; For quilted, with V = Q - floor(Q) - 1/2 in each coordinate, and t = |V|:
;
;   N' = N' + amount (t^3 + 3 c0 t (1 - t)^2 + 3 c1 t^2 (1 - t)) 2 / sqrt(3) V
;
; c0 and c1 = control0 and control1; BUMP_CORNERS holds this as a polynomial of
; t.
;
; A map of bumps has values v0, v1 .., in the space of a pattern with the value
; v at the point.  The normals N_i in that space give (1 - u) N_i + u N_i+1,
; with u from 0 to 1 between v_i and v_i+1; for an average they give their
; weighted sum.  The normal in the world is L^T of that, normalised.
;
; The ray may see the back of the new normal (spawn_vector.s, spawn_scalar.s).
; Then a refracted ray bends the other way.  A reflected ray that would go
; behind the surface is reflected by the old normal instead, if it is also
; behind the new one; otherwise it is reflected by the old one a second time.
; The old normal decides which side of the surface is seen.
; Source: POV-Ray 3.7's normal, by its documentation, verified by its pictures.

        .record HEIGHT                  ; of a map; the last one is beyond big
        .field  HEIGHT_AT
        .field  HEIGHT_SLOPE            ; 1 / distance to the next one
        .field  HEIGHT_TERMS, 4         ; coefficients of u^0 .. u^3
        .endrecord

        .record BUMP
        .field  BUMP_MAP, MAP_SIZE      ; a MAP without stops; function 0: an
                                        ; average, or quilted
        .field  BUMP_HEIGHTS            ; address of the first HEIGHT, which
                                        ; precedes the first value, or 0
        .field  BUMP_TO_LOCAL, 12       ; from the world to the function's space
        .field  BUMP_TRANSFORM, 9       ; M^T, by rows
        .field  BUMP_BACK, 9            ; L^T; of an entry from its map's space
        .field  BUMP_SCALED             ; 1: N' is normalised; the next: N is
        .field  BUMP_NORMALISED
        .field  BUMP_CORNERS, 24        ; per corner: a c, in the function's
                                        ; space, and push c; quilted: factors of
                                        ; t, t^2, t^3
        .field  BUMP_FROM               ; of an entry: it is the upper one from
        .field  BUMP_TO                 ; here on, and the lower one from here
        .field  BUMP_LOW                ; on; its value, 1 / distance to the
        .field  BUMP_RISE               ; next one; of an average its weight
        .field  BUMP_ENTRIES            ; of a map: address of the first, or 0;
        .field  BUMP_ENTRY_COUNT        ; their number
        .endrecord
        .equ    BUMP_FUNCTION, BUMP_MAP + MAP_FUNCTION
        .equ    BUMP_WAVE, BUMP_MAP + MAP_WAVE
        .equ    BUMP_NUMBERS, BUMP_MAP + MAP_NUMBERS
        .equ    BUMP_CORNER_SIZE, 6

; Computes the three products with the nine words from b0 on.
        .macro  bump_rows x0, x1, x2, y0, y1, y2
        dot_numbers \x0, \x1, \x2, b0, b1, b2, \y0, t0
        dot_numbers \x0, \x1, \x2, b3, b4, b5, \y1, t0
        dot_numbers \x0, \x1, \x2, b6, b7, b8, \y2, t0
        .endm

        .macro  bump_axis k0, k1, k2, k3, q
        dot_numbers px, py, pz, \k0, \k1, \k2, \q, t0
        raise   \q, \k3, \q
        .endm

        .macro  bump_place x, y, z
        load_part bump_at, BUMP_TO_LOCAL, 12, b0, here
        bump_axis b0, b1, b2, b3, \x
        bump_axis b4, b5, b6, b7, \y
        bump_axis b8, b9, b10, b11, \z
        .endm

; v = the position of q in its unit cube, relative to its centre.
        .macro  quilt_place q, v
        copy    \q, \v
        less_floor \v, t0
        lower   \v, m_half, \v
        .endm

        .macro  quilt_push v, normal
        times   t1, \v, t2
        plus    t2, \normal, \normal
        .endm

        .macro  call_bump
        call_routine find_bump, bump_link
        .endm

        .macro  call_height
        call_routine find_height, height_link
        .endm

; Applies the bumps of bump_at to nx, ny, nz and facing; raw_x .. = the old
; normal.
        .macro  apply_bumps
        load_of bump_at, BUMP_ENTRY_COUNT, bump_left
        IBXNE   bump_left, r0, r0, bumped_by_map\@
        call_bump
bumped_found\@:
        copy_three lx, ly, lz, nx, ny, nz, copy
        dot_product nx, ny, nz, hdx, hdy, hdz, facing, t0
        leave_bumped bumped\@

bumped_by_map\@:
        RTOR    bump_at, bump_outer
        load_part bump_at, BUMP_MAP, MAP_SIZE, map_function, here
        IBXEQ   map_function, r0, r0, bumped_by_all\@
        bump_place q_x, q_y, q_z
        call_height
        copy    y_0, bump_value
        load_of bump_at, BUMP_ENTRIES, bump_at
        sum_of_two_entries
bumped_summed\@:
        RTOR    bump_outer, bump_at
        load_part bump_at, BUMP_BACK, 9, b0, here
        bump_rows bump_sum_x, bump_sum_y, bump_sum_z, lx, ly, lz
        unit_vector lx, ly, lz, t0, t1
        BIM     bumped_found\@

bumped_by_all\@:
        load_of bump_at, BUMP_ENTRIES, bump_at
        set     m_zero, bump_sum_x
        set     m_zero, bump_sum_y
        set     m_zero, bump_sum_z
bumped_each\@:
        call_bump
        load_of bump_at, BUMP_RISE, bump_weight
        scaled_plus lx, bump_weight, bump_sum_x, bump_sum_x
        scaled_plus ly, bump_weight, bump_sum_y, bump_sum_y
        scaled_plus lz, bump_weight, bump_sum_z, bump_sum_z
        IX      bump_at, 64 * BUMP_SIZE
        IBXNE   bump_left, m_index_minus_one, r0, bumped_each\@, bump_left
        BIM     bumped_summed\@
bumped\@:
        .endm

        .kernel shade
        begin_bumps

; lx, ly, lz = the normal by the bump in bump_at, in the space of its map.
find_bump:
        bump_place bump_x, bump_y, bump_z
        load_part bump_at, BUMP_TRANSFORM, 9, b0, here
        bump_rows raw_x, raw_y, raw_z, lx, ly, lz
        load_of bump_at, BUMP_SCALED, bump_flag
        IBXEQ   bump_flag, r0, r0, bump_unscaled
        unit_vector lx, ly, lz, t0, t1
bump_unscaled:
        load_part bump_at, BUMP_MAP, MAP_SIZE, map_function, here
        IBXEQ   map_function, r0, r0, bump_quilted
        address_of bump_at, BUMP_CORNERS, bump_corner
        ES      bump_corners_left, 4
bump_next:
        load_from bump_corner, BUMP_CORNER_SIZE, b0
        three   raise, bump_x, bump_y, bump_z, b0, b1, b2, q_x, q_y, q_z
        call_height
        scaled_plus y_0, b3, lx, lx
        scaled_plus y_0, b4, ly, ly
        scaled_plus y_0, b5, lz, lz
        IX      bump_corner, 64 * BUMP_CORNER_SIZE
        IBXNE   bump_corners_left, m_index_minus_one, r0, bump_next, bump_corners_left
bump_back:
        load_part bump_at, BUMP_BACK, 9, b0, here
        bump_rows lx, ly, lz, q_x, q_y, q_z
        load_of bump_at, BUMP_NORMALISED, bump_flag
        IBXEQ   bump_flag, r0, r0, bump_returned
        unit_vector q_x, q_y, q_z, t0, t1
bump_returned:
        copy_three q_x, q_y, q_z, lx, ly, lz, copy
        BIM     0, bump_link

bump_quilted:
        load_part bump_at, BUMP_CORNERS, 3, b0, here
        quilt_place bump_x, q_x
        quilt_place bump_y, q_y
        quilt_place bump_z, q_z
        dot_product q_x, q_y, q_z, q_x, q_y, q_z, t0, t1
        root    t0, t0
        line    t0, b2, b1, t1
        times   t1, t0, t1
        raised_times t1, b0, t0, t1
        quilt_push q_x, lx
        quilt_push q_y, ly
        quilt_push q_z, lz
        BIM     bump_back

; y_0 = the height at q_x, q_y, q_z, by map_function .. and the bump's map.
find_height:
        call_routine find_value, pattern_link
        load_of bump_at, BUMP_HEIGHTS, height_at
        IBXEQ   height_at, r0, r0, height_found
        each_height height_next, height_last
        lowered_scale y_0, height_from, height_slope, t1
        line    t1, height_3, height_2, t2
        times   t2, t1, t2
        raised_times t2, height_1, t1, t2
        set_height height_next, height_last
height_found:
        BIM     0, height_link
        .endkernel
