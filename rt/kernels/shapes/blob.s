; blob.s - intersects rays with a blob: the surface on which the sum of the
; fields of its components is T.
;
; A component of strength S and radius r adds, at distance d from it,
;
;   S g^2,   g = 1 - d^2/r^2         if d < r, else 0.
;
; Along a ray d^2 is a quadratic, g = c + 2 b t + a t^2, and the field is a
; quartic on the interval where d < r: a piece.  A ball has one piece, like an
; ellipsoid, which is a ball in a space of its own.  A cylinder has three: d
; is the distance from the axis between the planes of its two ends, and the
; distance from the nearer end outside them.  A piece begins exactly where its
; neighbour ends, so there is no gap.
;
; t is measured from the ray's closest approach to the blob's centre.  For each
; piece a, b, c and the two ends of its interval are computed once.  Each ray is
; then walked from one such end, t0, to the next.  On each of these intervals
; the sum of the pieces that cover it is one quartic.  It is formed about t0, so
; that no powers above the second cancel:
;
;   b' = b + a t0     c' = c + (b + b') t0
;   S (c' + 2 b' s + a s^2)^2 = S (a^2 s^4 + 4 a b' s^3 + (4 b'^2 + 2 a c') s^2
;                                  + 4 b' c' s + c'^2)
;
; If the Bernstein coefficients on the interval have one sign, it has no root.
; Otherwise the root solver finds all changes of sign.  The field at t0 equals
; the field at the end of the previous interval except for rounding.  If their
; signs differ, there is a crossing at t0.  So a ray that has entered also
; leaves.
;
; A ray misses if the sum of the maxima of its pieces is below T.  In the vector
; form finished rays are removed by compression when they are more than half of
; the lanes.
;
;       CALL BLOB (RAY, PRIMITIVE, SEGMENT)
;       CALL BLOB_SOLID (RAY, PRIMITIVE, SEGMENTS)
;
; In:  ox oy oz dx dy dz lower, near long; the primitive's record and table.
; Out: tin = tout = the nearest crossing; a miss is big, minus_big.
;      blob_solid: P_SEGMENTS segments in successive vectors from tin on.
; Record: centre 3, square of its bound, threshold, number of rows, resolution
;         of distances.  Table: rows (records.s).
; Source: the field: POV-Ray's manual, 3.7; the walk: derived here.

        .if     BLOB_PIECES
        include_form lanes

        .data
blob_numbers:   .word 0.25, 0.16666666666666667, 4.0
        .code

        include_form blob

; ---- The pieces

; Adds the piece of a ball.
        .macro  take_ball
        ray_lower ray_x, part_x, part_ox
        ray_lower ray_y, part_y, part_oy
        ray_lower ray_z, part_z, part_oz
        dot_vectors part_ox, part_oy, part_oz, near_dx, near_dy, near_dz, side_b, work2
        dot_vectors part_ox, part_oy, part_oz, part_ox, part_oy, part_oz, side_c, work2
        ray_from part_square, side_c, side_c
        ray_times side_b, side_b, side_disc
        ray_plus side_disc, side_c, side_disc
        keep_crossing side_disc, side_root, blob_next_row
        ray_plus side_b, side_root, reach_from
        ray_minus side_root, side_b, reach_to
        ray_from r0, reach_from, reach_from
        take_piece reach_from, reach_to, blob_next_row
        put_ball
        ray_scale side_disc, part_inverse, side_disc
        add_most side_disc, hits1
        next_piece
        .endm

; Computes the ray in the part's own space.
        .macro  part_axes
        dot_constants ray_x, ray_y, ray_z, b00, b01, b02, b10, b11, b12, b20, b21, b22, part_ox, part_oy, part_oz, work0, work1, work2, work3
        ray_raise part_ox, b03, part_ox
        ray_raise part_oy, b13, part_oy
        ray_raise part_oz, b23, part_oz
        dot_constants near_dx, near_dy, near_dz, b00, b01, b02, b10, b11, b12, b20, b21, b22, part_dx, part_dy, part_dz, work0, work1, work2, work3
        .endm

        .macro  take_ellipsoid
        part_axes
        dot_vectors part_dx, part_dy, part_dz, part_dx, part_dy, part_dz, side_a, work0
        dot_vectors part_ox, part_oy, part_oz, part_dx, part_dy, part_dz, side_b, work1
        dot_vectors part_ox, part_oy, part_oz, part_ox, part_oy, part_oz, side_c, work2
        ray_from one, side_c, side_c
        ray_into one, side_a, side_inverse
        reach_of side_a, side_b, side_c, side_inverse, reach_from, reach_to, side_disc, side_root, blob_next_row
        take_piece reach_from, reach_to, blob_next_row
        put_piece side_a, side_b, side_c
        ray_times side_disc, side_inverse, side_disc
        add_most side_disc, hits1
        next_piece
        .endm

; Adds the piece between the planes: side_a t^2 + 2 side_b t - side_c is the
; squared distance from the axis, minus 1.  A ray along the axis is near it
; everywhere or nowhere.
        .macro  take_side
        ray_times part_dx, part_dx, side_a
        ray_times part_dy, part_dy, work0
        ray_times part_ox, part_dx, side_b
        ray_times part_oy, part_dy, work1
        ray_times part_ox, part_ox, side_c
        ray_times part_oy, part_oy, work2
        ray_plus work0, side_a, side_a
        ray_plus work1, side_b, side_b
        ray_plus work2, side_c, side_c
        MPYS    tiny, tiny, side_least
        ray_from one, side_c, side_c
        reach_of_side
        add_most side_disc, hits0
        lane_not_below first_at, reach_from
        lane_not_above last_at, reach_to
        take_piece reach_from, reach_to, side_none
        put_piece side_a, side_b, side_c
        next_piece
side_none:
        .endm

; Adds the piece of the half ball at one end, end_a t^2 + 2 end_b t - end_c,
; which is the squared distance from that end, minus 1.  The piece is cut at
; `cut`: x is not above it or not below it.
        .macro  take_end z, limit, cut, x
        ray_times \z, part_dz, end_b
        ray_times \z, \z, end_c
        ray_plus end_b, side_b, end_b
        ray_minus side_c, end_c, end_c
        reach_of end_a, end_b, end_c, end_inverse, end_from, end_to, end_disc, end_root, end_none\@
        lane_\limit \cut, \x
        take_piece end_from, end_to, end_none\@
        put_piece end_a, end_b, end_c
        next_piece
end_none\@:
        .endm

        .macro  take_cylinder
        part_axes
        find_ends
        take_side
        ray_times part_dz, part_dz, end_a
        ray_plus end_a, side_a, end_a
        ray_into one, end_a, end_inverse
        take_end first_z, not_above, first_at, end_to
        take_end last_z, not_below, last_at, end_from
        .endm

; Stores the pieces of all components.  Sets interval_t, where the walk starts:
; at the lower limit or at the first entry into a piece, whichever is later.
; Branches to none if no ray enters a piece.
        .macro  take_pieces none
        begin_pieces
blob_part:
        load_from blob_row, 7, part_kind        ; to part_strength
        CFPNE   part_kind, r0, blob_moved
        take_ball
        BIM     blob_next_row
blob_moved:
        load_part blob_row, BLOB_LENGTH, 13, part_length, blob_words ; also b00 .. b23
        CFPNE   part_kind, one, blob_long
        take_ellipsoid
        BIM     blob_next_row
blob_long:
        take_cylinder
blob_next_row:
        IX      blob_row, 64 * BLOB_SIZE
        SUBN    blob_rows_left, one, blob_rows_left
        CFPLT   r0, blob_rows_left, blob_part
        end_pieces \none
        .endm

; ---- The walk

; Adds the field of the piece about the interval's start.
        .macro  add_piece
        load_strength
        ray_times piece_a, interval_t, q0
        ray_scale piece_a, strength, q3         ; S a
        ray_plus piece_b, q0, q1                ; b'
        ray_plus piece_b, q1, q2
        ray_scale q1, strength4, q4             ; 4 S b'
        ray_times q2, interval_t, q2
        ray_times q3, piece_a, q5
        ray_plus q2, piece_c, q2                ; c'
        ray_times q4, piece_a, q6
        ray_times q4, q1, q7
        ray_scale q2, strength, q8              ; S c'
        ray_times q3, q2, q9
        add_to  k4, q5
        add_to  k3, q6
        add_to  k2, q7
        ray_plus q9, q9, q9
        ray_times q4, q2, q4
        ray_times q8, q2, q8
        add_to  k2, q9
        add_to  k1, q4
        add_to  k0, q8
        .endm

; Compares the signs of the Bernstein coefficients on the interval with that at
; its start.
        .macro  test_interval alike
        ray_minus interval_end, interval_t, interval_length
        begin_signs
        ray_times interval_length, interval_length, q4
        ray_times k1, interval_length, q0
        ray_times q4, interval_length, q5
        ray_times k2, q4, q1
        ray_times q4, q4, q6
        ray_times k3, q5, q2
        ray_scale q0, blob_quarter, q4
        ray_scale q1, blob_sixth, q5
        ray_times k4, q6, q3
        ray_scale q2, blob_quarter, q6
        ray_plus k0, q4, q7
        ray_plus q4, q5, q4
        signs_of q7, interval_signs_differ
        ray_plus q7, q4, q8
        ray_plus q4, q5, q4
        signs_of q8, interval_signs_differ
        ray_plus q4, q6, q4
        ray_plus k0, q0, q9
        ray_plus q8, q4, q8
        ray_plus q9, q1, q9
        signs_of q8, interval_signs_differ
        ray_plus q9, q2, q9
        ray_plus q9, q3, q9
        signs_of q9, interval_signs_differ
        end_signs interval_signs_differ, \alike
        .endm

; ---- The routines

        .macro  begin_blob find, miss
        three   ray_lower, ox, oy, oz, sh0, sh1, sh2, t5, t6, t7
        \find   t5, t6, t7, sh3, \miss
        .endm

        .kernel blob
blob_solid:
        enter_blob_solid
        begin_blob find_all_lanes, blob_none
        BIM     blob_begin
blob:
        enter_blob
        begin_blob find_lanes, blob_miss
blob_begin:
        begin_lanes
        take_pieces blob_end
        load_words blob_numbers, 3, blob_quarter, blob_words ; also blob_sixth, blob_four
        walk_blob
        .endkernel

        .endif
