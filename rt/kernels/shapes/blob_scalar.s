; blob_scalar.s - intersects one ray with a blob.
;
;       CALL BLOB (RAY, PRIMITIVE, SEGMENT)
;       CALL BLOB_SOLID (RAY, PRIMITIVE, SEGMENTS)
;
; The arguments are those of sphere_scalar.s, the method is that of
; blob_vector.s.  SEGMENTS receives P_SEGMENTS segments of the ray inside the
; blob.  The pieces that the ray enters are kept in blob_list.

        .if     BLOB_PIECES

        include_form lanes
        .share  local
        .regs   r91, part_kind, part_x, part_y, part_z, part_square, part_inverse
        .regs   r97, part_strength, part_length
        .regs   r99, b00, b01, b02, b03, b10, b11, b12, b13, b20, b21, b22, b23
        .regs   r111, part_strength4                    ; an entry of the list:
        .regs   r112, piece_enter, piece_leave, piece_a, piece_b, piece_c, piece_strength
        .regs   r118, u0, u1, u2, p0, p1, p2, side_a, side_b, side_c
        .regs   r127, first_z, first_at, last_z, last_at, cap_z
        .regs   r132, interval_t, interval_end, interval_length, most_field, interval_inside
        .regs   r137, blob_row, blob_rows_left, piece_at, pieces_end
        .regs   r141, columns_end, column_at, walk_first, interval_pieces
        .regs   r145, blob_quarter, blob_sixth, blob_four, blob_crossed_at
        .regs   r149, f0, f1, f2, f3
        .endshare
        .regs   t0, q0, q1, q2, q3, q4, q5, q6, q7, q8, q9
        .reg    strength, piece_strength
        .reg    strength4, fourth
        .include "shapes/blob_terms.s"
        .equ    BLOB_REGISTERS, 121
        .equ    PIECE_WORDS, 6

        .data
blob_save:      .space BLOB_REGISTERS
blob_list:      .space PIECE_WORDS * BLOB_PIECES
        .code

; ---- The pieces

; Computes the interval from .. to in which a t^2 + 2 b t - c is below 0, for
; a > 0.  Branches to nowhere if there is none.
        .macro  reach_of a, b, c, inverse, from, to, disc, nowhere
        MPYS    \b, \b, \disc
        MPYS    \a, \c, t0
        ADDN    t0, \disc, \disc
        CFPGE   r0, \disc, \nowhere
        SQRT    \disc, t0
        ADDN    \b, t0, \from
        SUBN    t0, \b, \to
        SUBN    r0, \from, \from
        MPYS    \to, \inverse, \to
        MPYS    \from, \inverse, \from
        .endm

; Branches to none if the piece piece_enter .. piece_leave is empty or not ahead
; of the ray.  Otherwise lowers interval_t to piece_enter.
        .macro  take_piece none
        CFPGE   piece_enter, piece_leave, \none
        CFPGE   near_low, piece_leave, \none
        CFPGE   piece_enter, interval_t, take_piece\@
        RTOR    piece_enter, interval_t
take_piece\@:
        .endm

        .macro  list_piece
        ELEN    pieces_end, PIECE_WORDS
        SWAP    [r0], piece_enter, [pieces_end]
        IX      pieces_end, 64 * PIECE_WORDS
        .endm

        .macro  add_most g
        CFPGE   r0, piece_strength, add_most\@
        MPYS    \g, \g, t0
        MPYS    t0, piece_strength, t0
        ADDN    most_field, t0, most_field
add_most\@:
        .endm

        .macro  take_ball
        SUBN    u0, part_x, f0
        SUBN    u1, part_y, f1
        SUBN    u2, part_z, f2
        dot     f0, f1, f2, dx, dy, dz, t1, t2
        dot     f0, f1, f2, f0, f1, f2, t3, t2
        SUBN    part_square, t3, t3
        MPYS    t1, t1, t4
        ADDN    t4, t3, t4
        CFPGE   r0, t4, blob_next_row
        SQRT    t4, t5
        ADDN    t1, t5, piece_enter
        SUBN    t5, t1, piece_leave
        SUBN    r0, piece_enter, piece_enter
        take_piece blob_next_row
        SUBN    r0, part_inverse, piece_a
        MPYS    t1, piece_a, piece_b
        MPYS    t3, part_inverse, piece_c
        MPYS    t4, part_inverse, t4
        add_most t4
        list_piece
        .endm

; The ray in the part's own space: origin t1-t3, direction p0-p2.
        .macro  part_axes
        dot_rows u0, u1, u2, b00, b01, b02, b10, b11, b12, b20, b21, b22, t1, t2, t3, f0, f1, f2, f3
        ADDN    t1, b03, t1
        ADDN    t2, b13, t2
        ADDN    t3, b23, t3
        dot_rows dx, dy, dz, b00, b01, b02, b10, b11, b12, b20, b21, b22, p0, p1, p2, f0, f1, f2, f3
        .endm

        .macro  put_piece a, b, c
        SUBN    r0, \a, piece_a
        SUBN    r0, \b, piece_b
        RTOR    \c, piece_c
        .endm

        .macro  take_ellipsoid
        part_axes
        dot     p0, p1, p2, p0, p1, p2, side_a, f0
        dot     t1, t2, t3, p0, p1, p2, side_b, f1
        dot     t1, t2, t3, t1, t2, t3, side_c, f2
        SUBN    one, side_c, side_c
        DIVS    one, side_a, t4
        reach_of side_a, side_b, side_c, t4, piece_enter, piece_leave, t5, blob_next_row
        take_piece blob_next_row
        put_piece side_a, side_b, side_c
        MPYS    t5, t4, t5
        add_most t5
        list_piece
        .endm

        .macro  find_ends
        SUBN    t3, part_length, cap_z
        ABS     p2, t4
        CFPLT   t4, tiny, find_along\@
        DIVS    one, p2, t4
        RTOR    t3, first_z
        RTOR    cap_z, last_z
        CFPGE   p2, r0, find_rising\@
        RTOR    cap_z, first_z
        RTOR    t3, last_z
find_rising\@:
        SUBN    r0, first_z, first_at
        SUBN    r0, last_z, last_at
        MPYS    first_at, t4, first_at
        MPYS    last_at, t4, last_at
        BIM     find_ends\@
find_along\@:
        RTOR    t3, first_z
        RTOR    cap_z, last_z
        RTOR    minus_big, first_at
        RTOR    big, last_at
        CFPGE   t3, r0, find_above\@
        RTOR    big, first_at
find_above\@:
        CFPGE   r0, cap_z, find_ends\@
        RTOR    minus_big, last_at
find_ends\@:
        .endm

        .macro  rise_to low, x
        CFPGE   \x, \low, rise_to\@
        RTOR    \low, \x
rise_to\@:
        .endm

        .macro  sink_to high, x
        CFPGE   \high, \x, sink_to\@
        RTOR    \high, \x
sink_to\@:
        .endm

        .macro  take_side
        MPYS    p0, p0, side_a
        MPYS    p1, p1, t4
        MPYS    t1, p0, side_b
        MPYS    t2, p1, t5
        MPYS    t1, t1, side_c
        MPYS    t2, t2, t6
        ADDN    t4, side_a, side_a
        ADDN    t5, side_b, side_b
        ADDN    t6, side_c, side_c
        MPYS    tiny, tiny, t7
        SUBN    one, side_c, side_c
        CFPLT   side_a, t7, side_along
        DIVS    one, side_a, t4
        reach_of side_a, side_b, side_c, t4, piece_enter, piece_leave, t5, blob_next_row
        MPYS    t5, t4, t5
        BIM     side_found
side_along:
        CFPGE   r0, side_c, blob_next_row
        RTOR    side_c, t5
        RTOR    minus_big, piece_enter
        RTOR    big, piece_leave
side_found:
        add_most t5
        rise_to first_at, piece_enter
        sink_to last_at, piece_leave
        take_piece side_none
        put_piece side_a, side_b, side_c
        list_piece
side_none:
        .endm

; Adds the piece of the half ball at one end, t5 t^2 + 2 t7 t - t8, clipped to
; the part before cut (leave_at) or after it (enter_at).
        .macro  take_end z, limit, cut
        MPYS    \z, p2, t7
        MPYS    \z, \z, t8
        ADDN    t7, side_b, t7
        SUBN    side_c, t8, t8
        reach_of t5, t7, t8, t6, piece_enter, piece_leave, t9, end_none\@
        \limit  \cut
        take_piece end_none\@
        put_piece t5, t7, t8
        list_piece
end_none\@:
        .endm

        .macro  leave_at cut
        sink_to \cut, piece_leave
        .endm

        .macro  enter_at cut
        rise_to \cut, piece_enter
        .endm

        .macro  take_cylinder
        part_axes
        find_ends
        take_side
        MPYS    p2, p2, t5
        ADDN    t5, side_a, t5
        DIVS    one, t5, t6
        take_end first_z, leave_at, first_at
        take_end last_z, enter_at, last_at
        .endm

; Lists the pieces of all components.  Sets interval_t, where the walk starts:
; at the lower limit or at the first entry into a piece, whichever is later.
; Branches to none if the ray enters no piece, or if the sum of their maxima is
; below T.
        .macro  take_pieces none
        RTOR    t0, u0
        RTOR    t1, u1
        RTOR    t2, u2
        RTOR    big, interval_t
        ADDN    r0, r0, most_field
        EX      pieces_end, blob_list
        RTOR    a_primitive, t1
        IX      t1, 64 * P_TABLE
        LOD     [t1], blob_row
        RTOR    sh5, blob_rows_left
blob_part:
        ELEN    blob_row, 7
        SWAP    [blob_row], part_kind, [r0]
        RTOR    part_strength, piece_strength
        CFPNE   part_kind, r0, blob_moved
        take_ball
        BIM     blob_next_row
blob_moved:
        RTOR    blob_row, t1
        IX      t1, 64 * BLOB_LENGTH
        ELEN    t1, 13
        SWAP    [t1], part_length, [r0]         ; also b00 .. b23
        CFPNE   part_kind, one, blob_long
        take_ellipsoid
        BIM     blob_next_row
blob_long:
        take_cylinder
blob_next_row:
        IX      blob_row, 64 * BLOB_SIZE
        SUBN    blob_rows_left, one, blob_rows_left
        CFPLT   r0, blob_rows_left, blob_part
        CFPGE   interval_t, big, \none
        CFPLT   most_field, sh4, \none
        rise_to near_low, interval_t
        .endm

; ---- The walk

        .macro  load_strength
        MPYS    piece_strength, blob_four, strength4
        .endm

        .macro  add_to k, x
        ADDN    \k, \x, \k
        .endm

; Computes the interval interval_t .. interval_end, and in k4 .. k0 the field
; minus T on it.  interval_pieces: 1 if any piece covers the interval.
; interval_end = big: the interval is the last one.
        .macro  next_interval
        RTOR    big, interval_end
        ADDN    r0, r0, k4
        ADDN    r0, r0, k3
        ADDN    r0, r0, k2
        ADDN    r0, r0, k1
        SUBN    r0, sh4, k0
        ES      interval_pieces, 0
        EX      piece_at, blob_list
interval_piece:
        ELEN    piece_at, PIECE_WORDS
        SWAP    [piece_at], piece_enter, [r0]
        IX      piece_at, 64 * PIECE_WORDS
        CFPGE   interval_t, piece_leave, interval_next
        CFPLT   interval_t, piece_enter, interval_ahead
        ES      interval_pieces, 1
        sink_to piece_leave, interval_end
        add_piece
        BIM     interval_next
interval_ahead:
        sink_to piece_enter, interval_end
interval_next:
        IBXNE   piece_at, r0, pieces_end, interval_piece
        .endm

; e6 = 1 if the field is at least T at the start of the interval.  Branches to
; differ if the sign of k is another one; else end_signs branches to alike.
        .macro  begin_signs
        ES      e6, 1
        CFPGE   k0, r0, interval_begins
        ES      e6, 0
interval_begins:
        .endm

        .macro  signs_of k, differ
        CFPGE   \k, r0, signs_above\@
        IBXNE   e6, r0, r0, \differ
        BIM     signs_same\@
signs_above\@:
        IBXEQ   e6, r0, r0, \differ
signs_same\@:
        .endm

        .macro  end_signs differ, alike
        BIM     \alike
\differ:
        .endm

; Records a crossing, relative to the ray's origin instead of its closest
; approach.  BLOB (columns_end = 0) needs only the first one and returns;
; BLOB_SOLID stores the crossing if there is room.
        .macro  take_crossing at
        SUBN    \at, along, blob_crossed_at
        IBXEQ   columns_end, r0, r0, blob_hit
        IBXEQ   column_at, r0, columns_end, take_full\@
        STO     [column_at], blob_crossed_at
        IX      column_at, 64
take_full\@:
        .endm

; Records a crossing at interval_t if the sign there differs from the sign at the
; end of the previous interval.
        .macro  signs_at_beginning
        IBXNE   walk_first, r0, r0, signs_done\@
        IBXEQ   e6, r0, interval_inside, signs_done\@
        take_crossing interval_t
signs_done\@:
        ES      walk_first, 0
        .endm

        .macro  take_roots
        ADDN    r0, r0, near_low
        RTOR    interval_length, near_high
        solve_all sh6                           ; e0 roots, from address e1 on
take_root:
        CFPGE   r0, e0, take_last
        LOD     [e1], t3
        IX      e1, 64
        SUBN    e0, one, e0
        ADDN    interval_t, t3, t3
        XOR     e6, index_one, e6
        take_crossing t3
        BIM     take_root
take_last:
        .endm

        .kernel blob
blob_solid:
        enter_solver 7, blob_save, BLOB_REGISTERS
        RTOR    a_segment, column_at
        RTOR    a_primitive, t0
        IX      t0, 64 * P_SEGMENTS
        LOD     [t0], t0
        SHIFTI  t0, 7, t0
        ADDX    column_at, t0, columns_end
        ES      walk_first, 0
        SUBN    ox, sh0, f0
        SUBN    oy, sh1, f1
        SUBN    oz, sh2, f2
        find_all_lanes f0, f1, f2, sh3, blob_fill
        BIM     blob_begin
blob:
        enter_solver 7, blob_save, BLOB_REGISTERS
        ES      columns_end, 0
        ES      walk_first, 1
        SUBN    ox, sh0, f0
        SUBN    oy, sh1, f1
        SUBN    oz, sh2, f2
        find_lanes f0, f1, f2, sh3, blob_miss
blob_begin:
        EX      t3, blob_numbers
        ELEN    t3, 3
        SWAP    [t3], blob_quarter, [r0]        ; and blob_sixth, blob_four
        take_pieces blob_end
        ES      interval_inside, 0
blob_walk:
        next_interval
        IBXEQ   interval_pieces, r0, r0, blob_outside
        test_interval blob_alike
        signs_at_beginning
        take_roots
        RTOR    e6, interval_inside
        BIM     blob_continue
blob_outside:
        ES      e6, 0
blob_alike:
        signs_at_beginning
        RTOR    e6, interval_inside
blob_continue:
        RTOR    interval_end, interval_t
        CFPLT   interval_t, big, blob_walk
blob_end:
        IBXEQ   columns_end, r0, r0, blob_miss
blob_fill:
        IBXEQ   column_at, r0, columns_end, blob_filled
        STO     [column_at], big
        STO     [column_at, index_one], minus_big
        IX      column_at, 64 * 2
        BIM     blob_fill
blob_filled:
        leave_segments blob_save, BLOB_REGISTERS
blob_hit:
        RTOR    blob_crossed_at, tin
        RTOR    blob_crossed_at, tout
        leave_solver blob_save, BLOB_REGISTERS
blob_miss:
        miss_near blob_save, BLOB_REGISTERS
        .endkernel

        .endif
