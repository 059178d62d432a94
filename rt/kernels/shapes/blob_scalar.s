; blob_scalar.s - the scalar form of the blob.  The pieces that the ray enters
; are stored in blob_list.

        .share  local
        .regs   r91, part_kind, part_x, part_y, part_z, part_square, part_inverse
        .regs   r97, part_strength, part_length
        .regs   r99, b00, b01, b02, b03, b10, b11, b12, b13, b20, b21, b22, b23
        .regs   r111, part_strength4                    ; an entry of the list:
        .regs   r112, piece_enter, piece_leave, piece_a, piece_b, piece_c, piece_strength
        .regs   r118, ray_x, ray_y, ray_z, part_dx, part_dy, part_dz
        .regs   r124, side_a, side_b, side_c
        .regs   r127, first_z, first_at, last_z, last_at, cap_z
        .regs   r132, interval_t, interval_end, interval_length, most_field, interval_inside
        .regs   r137, blob_row, blob_rows_left, piece_at, pieces_end
        .regs   r141, columns_end, column_at, walk_first, interval_pieces
        .regs   r145, blob_quarter, blob_sixth, blob_four, blob_crossed_at
        .regs   r149, work0, work1, work2, work3
        .endshare
        .regs   t0, q0, q1, q2, q3, q4, q5, q6, q7, q8, q9
        .regs   t0, side_root, part_ox, part_oy, part_oz, side_inverse, side_disc, end_inverse
        .regs   t5, end_a
        .regs   t7, end_b, end_c, end_disc
        .reg    side_least, t7
        .reg    end_root, t0
        .regs   piece_enter, reach_from, reach_to
        .regs   piece_enter, end_from, end_to
        .reg    blob_words, t4
        .reg    strength, piece_strength
        .reg    strength4, fourth
        .equ    BLOB_REGISTERS, 121
        .equ    PIECE_WORDS, 6
        scalar_form lane_

        .data
blob_save:      .space BLOB_REGISTERS
blob_list:      .space PIECE_WORDS * BLOB_PIECES
        .code

; Computes the interval from .. to in which a t^2 + 2 b t - c is below 0, for
; a > 0.  Branches to nowhere if there is none.
        .macro  reach_of a, b, c, inverse, from, to, disc, root, nowhere
        MPYS    \b, \b, \disc
        MPYS    \a, \c, \root
        ADDN    \root, \disc, \disc
        CFPGE   r0, \disc, \nowhere
        SQRT    \disc, \root
        ADDN    \b, \root, \from
        SUBN    \root, \b, \to
        SUBN    r0, \from, \from
        MPYS    \to, \inverse, \to
        MPYS    \from, \inverse, \from
        .endm

        .macro  keep_crossing disc, root, nowhere
        CFPGE   r0, \disc, \nowhere
        SQRT    \disc, \root
        .endm

; Branches to none if the piece piece_enter .. piece_leave is empty or not ahead
; of the ray.  Otherwise lowers interval_t to piece_enter.
        .macro  take_piece from, to, none
        CFPGE   piece_enter, piece_leave, \none
        CFPGE   near_low, piece_leave, \none
        lane_not_above piece_enter, interval_t
        .endm

        .macro  next_piece
        RTOR    part_strength, piece_strength
        store_to piece_enter, PIECE_WORDS, pieces_end
        IX      pieces_end, 64 * PIECE_WORDS
        .endm

        .macro  add_most g, bits
        CFPGE   r0, part_strength, add_most\@
        MPYS    \g, \g, t0
        MPYS    t0, part_strength, t0
        ADDN    most_field, t0, most_field
add_most\@:
        .endm

        .macro  put_ball
        SUBN    r0, part_inverse, piece_a
        MPYS    side_b, piece_a, piece_b
        MPYS    side_c, part_inverse, piece_c
        .endm

        .macro  put_piece a, b, c
        SUBN    r0, \a, piece_a
        SUBN    r0, \b, piece_b
        RTOR    \c, piece_c
        .endm

        .macro  find_ends
        SUBN    part_oz, part_length, cap_z
        ABS     part_dz, t4
        CFPLT   t4, tiny, find_along\@
        DIVS    one, part_dz, t4
        RTOR    part_oz, first_z
        RTOR    cap_z, last_z
        CFPGE   part_dz, r0, find_rising\@
        RTOR    cap_z, first_z
        RTOR    part_oz, last_z
find_rising\@:
        SUBN    r0, first_z, first_at
        SUBN    r0, last_z, last_at
        MPYS    first_at, t4, first_at
        MPYS    last_at, t4, last_at
        BIM     find_ends\@
find_along\@:
        RTOR    part_oz, first_z
        RTOR    cap_z, last_z
        RTOR    minus_big, first_at
        RTOR    big, last_at
        CFPGE   part_oz, r0, find_above\@
        RTOR    big, first_at
find_above\@:
        CFPGE   r0, cap_z, find_ends\@
        RTOR    minus_big, last_at
find_ends\@:
        .endm

        .macro  reach_of_side
        CFPLT   side_a, side_least, side_along
        DIVS    one, side_a, side_inverse
        reach_of side_a, side_b, side_c, side_inverse, piece_enter, piece_leave, side_disc, side_root, blob_next_row
        MPYS    side_disc, side_inverse, side_disc
        BIM     side_found
side_along:
        CFPGE   r0, side_c, blob_next_row
        RTOR    side_c, side_disc
        RTOR    minus_big, piece_enter
        RTOR    big, piece_leave
side_found:
        .endm

        .macro  begin_pieces
        copy_three t0, t1, t2, ray_x, ray_y, ray_z
        RTOR    big, interval_t
        ADDN    r0, r0, most_field
        EX      pieces_end, blob_list
        load_field P_TABLE, blob_row
        RTOR    sh5, blob_rows_left
        .endm

; The ray also misses if the sum of the maxima of its pieces is below T.
        .macro  end_pieces none
        CFPGE   interval_t, big, \none
        CFPLT   most_field, sh4, \none
        lane_not_below near_low, interval_t
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
        load_from piece_at, PIECE_WORDS, piece_enter
        IX      piece_at, 64 * PIECE_WORDS
        CFPGE   interval_t, piece_leave, interval_next
        CFPLT   interval_t, piece_enter, interval_ahead
        ES      interval_pieces, 1
        lane_not_above piece_leave, interval_end
        add_piece
        BIM     interval_next
interval_ahead:
        lane_not_above piece_enter, interval_end
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

; Records a crossing at interval_t if the sign there differs from the sign at
; the end of the previous interval.
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

; ---- The routines

        .macro  enter_blob_solid
        enter_solver 7, blob_save, BLOB_REGISTERS
        RTOR    a_segment, column_at
        load_of a_primitive, P_SEGMENTS, t0
        SHIFTI  t0, 7, t0
        ADDX    column_at, t0, columns_end
        ES      walk_first, 0
        .endm

        .macro  enter_blob
        enter_solver 7, blob_save, BLOB_REGISTERS
        ES      columns_end, 0
        ES      walk_first, 1
        .endm

        no_code begin_lanes

        .macro  walk_blob
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
blob_none:
        IBXEQ   column_at, r0, columns_end, blob_filled
        STO     [column_at], big
        STO     [column_at, index_one], minus_big
        IX      column_at, 64 * 2
        BIM     blob_none
blob_filled:
        leave_segments blob_save, BLOB_REGISTERS
blob_hit:
        RTOR    blob_crossed_at, tin
        RTOR    blob_crossed_at, tout
        leave_solver blob_save, BLOB_REGISTERS
blob_miss:
        miss_near blob_save, BLOB_REGISTERS
        .endm
