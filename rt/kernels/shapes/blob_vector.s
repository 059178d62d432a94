; blob_vector.s - the vector form of the blob.

; Vectors, one word per lane: start, end and length of the current interval, the
; sum of the maxima of the pieces; for solids the index of the next crossing in
; the columns, and the number of free columns.
        .share  scratch
        .regs   r233, interval_t, interval_end, interval_length, most_field, crossing_at, columns_free
        .equ    BLOB_VECTORS, 6
        .regs   r239, piece_a, piece_b, piece_c, piece_enter, piece_leave
        .regs   piece_a, piece0, piece1, piece2, piece3, piece4
        .regs   r244, pieces_used
        .reg    nearest_interval, r245  ; 0: all crossings; 1, 2: the nearest;
        .endshare                       ; 1: in the first interval, 2: later
        .regs   s4, strength_at, pieces_left, blob_row, blob_rows_left
        .regs   m00, blob_quarter, blob_sixth, blob_four        ; in the walk
        .share  hits
        .reg    lane_inside, hits3
        .endshare

        .regs   e0, q0, q1, q2, q3, q4, q5, q6, q7, q8, q9
        .reg    strength, s2
        .reg    strength4, s3

; Before the walk: the part, the ray in its space, quadratics, intervals.
        .regs   sh8, part_kind, part_x, part_y, part_z, part_square, part_inverse
        .regs   sh14, part_strength, part_length
        .regs   m00, b00, b01, b02, b03, b10, b11, b12, b13, b20, b21, b22, b23
        .regs   lane_ox, ray_x, ray_y, ray_z
        .regs   e0, part_ox, part_oy, part_oz, part_dx, part_dy, part_dz
        .regs   e0, reach_from, reach_to
        .regs   e3, side_disc, side_root
        .regs   e6, side_a, side_b, side_c, side_inverse, work0, work1, work2
        .reg    work3, e12
        .regs   e0, end_b, end_c
        .regs   e3, end_a, end_inverse
        .regs   e9, end_from, end_to, end_disc, end_root
        .reg    side_least, s2
        .reg    blob_words, s2

; Vectors of a cylinder, used only before the walk.
        .reg    first_z, k0             ; heights over the ends, in ray order
        .reg    last_z, k1
        .reg    first_at, k2
        .reg    last_at, k3
        .reg    cap_z, k4

; Lanes at a time: at most 2000, and fewer if the pieces would take more than
; 2^24 words.
        .equ    PIECES_FIT, 3355443 / (BLOB_PIECES + 1)
        .if     PIECES_FIT < 2000 & PIECES_FIT < QUEUE
        .equ    BLOB_LANES, PIECES_FIT
        .elseif QUEUE > 2000
        .equ    BLOB_LANES, 2000
        .else
        .equ    BLOB_LANES, QUEUE
        .endif
        .equ    PIECE_SIZE, 5 * BLOB_LANES
        .reg    lanes_end, sh7

        .data
blob_strengths: .space BLOB_PIECES
        .align  64
blob_store:     .space PIECE_SIZE * BLOB_PIECES
        .code

        .macro  set_blob_lanes
        set_lanes m
        set_lengths m, m_high, lane_bases, lane_descriptors, BLOB_VECTORS, interval_t
        .endm
        vector_form lane_, hits1

; ---- The pieces

        .macro  next_vector before, vector
        address_of \before, BLOB_LANES, \vector
        .endm

        .macro  first_piece
        describe piece_a, blob_store, m
        next_vector piece_a, piece_b
        next_vector piece_b, piece_c
        next_vector piece_c, piece_enter
        next_vector piece_enter, piece_leave
        EX      strength_at, blob_strengths
        .endm

        .macro  next_piece
        .rept   5
        IX      piece\+, 64 * PIECE_SIZE
        .endr
        IX      strength_at, 64
        .endm

; Computes the interval [from] .. [to] in which [a] t^2 + 2 [b] t - [c] is below
; 0, for a > 0.  hits0 = the lanes that have one.  Changes disc (the
; discriminant) and root.
        .macro  reach_of a, b, c, inverse, from, to, disc, root, nowhere
        MPYSV   [\b], [\b], [\disc]
        MPYSV   [\a], [\c], [\root]
        ADDNV   [\root], [\disc], [\disc]
        CMPLTV  r0, [\disc], [hits0]
        SQRTV   [\disc], [\root] ? [hits0]
        ADDNV   [\b], [\root], [\from]
        MPYSV   -[\from], [\inverse], [\from]
        SUBNV   [\root], [\b], [\to]
        MPYSV   [\to], [\inverse], [\to]
        .endm

        .macro  keep_crossing disc, root, nowhere
        CMPLTV  r0, [\disc], [hits0]
        SQRTV   [\disc], [\root] ? [hits0]
        .endm

; Stores the interval [from] .. [to] of the lanes of hits0 as a piece and lowers
; interval_t to its start.  hits1 = the lanes that have it ahead of them.
; Branches to none if there are none.
        .macro  take_piece from, to, none
        CMPLTV  [\from], [\to], [hits1]
        ANDB    [hits0], [hits1], [hits1]
        keep_where CMPLTV, [lane_low], [\to], hits1, hits2
        if_none hits1, s0, \none
        MASKV   [\from], big, [piece_enter] ? [hits1]
        MASKV   [\to], big, [piece_leave] ? [hits1]
        CMPLTV  [\from], [interval_t], [hits2]
        ANDB    [hits1], [hits2], [hits2]
        VTOV    [\from], [interval_t] ? [hits2]
        STO     [strength_at], part_strength
        IX      pieces_used, 1
        .endm

; Adds the maximum of a piece, strength [g]^2, in the lanes of bits.
        .macro  add_most g, bits
        CFPGE   r0, part_strength, add_most\@
        MPYSV   [\g], [\g], [\g]
        MPYSV   [\g], part_strength, [\g]
        ADDNV   [most_field], [\g], [most_field] ? [\bits]
add_most\@:
        .endm

        .macro  put_ball
        SUBN    r0, part_inverse, s2
        VTOV    s2, [piece_a]
        MPYSV   [side_b], s2, [piece_b]
        MPYSV   [side_c], part_inverse, [piece_c]
        .endm

; Stores the coefficients of a piece: those of the quadratic with the sign of g.
        .macro  put_piece a, b, c
        VTOV    -[\a], [piece_a]
        VTOV    -[\b], [piece_b]
        VTOV    [\c], [piece_c]
        .endm

; first_at, last_at = where the ray crosses the planes of the first and of the
; second end on its way; first_z, last_z = the height of the origin above these
; ends.  A ray parallel to the planes stays on one side of each: its crossings
; are big or minus_big.
        .macro  find_ends
        SUBNV   [part_oz], part_length, [cap_z]
        CMPLTV  |[part_dz]|, tiny, [hits0]
        CMPLTV  [part_dz], r0, [hits1]
        ANDNB   [hits1], [hits0], [hits1]
        MASKV   one, [part_dz], [e6] ? [hits0]
        DIVSV   one, [e6], [e6]
        MASKV   [cap_z], [part_oz], [first_z] ? [hits1]
        MASKV   [part_oz], [cap_z], [last_z] ? [hits1]
        MPYSV   -[first_z], [e6], [first_at]
        MPYSV   -[last_z], [e6], [last_at]
        if_none hits0, s0, find_ends\@
        VTOV    minus_big, [first_at] ? [hits0]
        VTOV    big, [last_at] ? [hits0]
        CMPLTV  [part_oz], r0, [hits1]
        ANDB    [hits0], [hits1], [hits1]
        VTOV    big, [first_at] ? [hits1]
        CMPLTV  r0, [cap_z], [hits1]
        ANDB    [hits0], [hits1], [hits1]
        VTOV    minus_big, [last_at] ? [hits1]
find_ends\@:
        .endm

; Branches to blob_next_row if no ray comes near the axis, for then none comes
; near the ends.
        .macro  reach_of_side
        CMPLTV  [side_a], side_least, [hits2]
        MASKV   one, [side_a], [side_inverse] ? [hits2]
        DIVSV   one, [side_inverse], [side_inverse]
        reach_of side_a, side_b, side_c, side_inverse, reach_from, reach_to, side_disc, side_root, blob_next_row
        if_none hits2, s0, side_crossed
        VTOV    [side_c], [side_disc] ? [hits2]
        CMPLTV  r0, [side_disc], [hits0]
        VTOV    minus_big, [reach_from] ? [hits2]
        VTOV    big, [reach_to] ? [hits2]
side_crossed:
        if_none hits0, s0, blob_next_row
        MPYSV   [side_disc], [side_inverse], [side_disc]
        .endm

        .macro  begin_pieces
        set_blob_lanes
        first_piece
        VTOV    big, [interval_t]
        VTOV    r0, [most_field]
        ES      pieces_used, 0
        load_field P_TABLE, blob_row
        RTOR    sh5, blob_rows_left
        .endm

        .macro  end_pieces none
        CMPLTV  [most_field], sh4, [hits0]
        VTOV    big, [interval_t] ? [hits0]
        lane_not_below lane_low, interval_t
        VTOV    [lane_at], [crossing_at]
        load_field P_SEGMENTS, s2
        ADDN    s2, s2, s2
        VTOV    s2, [columns_free]
        XORB    [lane_inside], [lane_inside], [lane_inside]
        .endm

; ---- The walk

; Keeps only the lanes of hits1.  m = their number.
        .macro  keep_lanes
        CPSV    [lane_at], [lane_at] ? [hits1]
        CPSV    [lane_along], [lane_along] ? [hits1]
        CPSV    [interval_t], [interval_t] ? [hits1]
        CPSV    [crossing_at], [crossing_at] ? [hits1]
        CPSV    [columns_free], [columns_free] ? [hits1]
        CPSB    [lane_inside], [lane_inside] ? [hits1]
        first_piece
        RTOR    pieces_used, pieces_left
keep_piece\@:
        .rept   5
        CPSV    [piece\+], [piece\+] ? [hits1]
        lengthen m, piece\+
        .endr
        next_piece
        IBXNE   pieces_left, minus_one_index, r0, keep_piece\@, pieces_left
        CNTOB   [hits1], m
        set_blob_lanes
        .endm

; Branches to none if every lane has finished its walk.  Removes the finished
; lanes if they are more than half.
        .macro  leave_lanes none
        CMPLTV  [interval_t], big, [hits1]
        if_none hits1, s0, \none
        ADDX    s0, s0, s0
        IBXGE   s0, r0, m, leave_lanes\@
        keep_lanes
leave_lanes\@:
        .endm

        .macro  load_strength
        LOD     [strength_at], strength
        MPYS    strength, blob_four, strength4
        .endm

        .macro  add_to k, x
        ADDNV   [\k], [\x], [\k] ? [hits1]
        .endm

; Computes the interval interval_t .. interval_end of each lane, and in k4 .. k0
; the field minus T on it.  interval_end = big: the interval is the last one.
        .macro  next_interval
        VTOV    big, [interval_end]
        VTOV    r0, [k4]
        VTOV    r0, [k3]
        VTOV    r0, [k2]
        VTOV    r0, [k1]
        SUBN    r0, sh4, s2
        VTOV    s2, [k0]
        first_piece
        RTOR    pieces_used, pieces_left
interval_piece\@:
        CMPLTV  [interval_t], [piece_leave], [hits1]
        if_none hits1, s0, interval_next\@
        CMPLTV  [interval_t], [piece_enter], [hits0]
        MASKV   [piece_enter], [piece_leave], [e0] ? [hits0]
        CMPLTV  [e0], [interval_end], [hits2]
        ANDB    [hits1], [hits2], [hits2]
        VTOV    [e0], [interval_end] ? [hits2]
        ANDNB   [hits1], [hits0], [hits1]
        if_none hits1, s0, interval_next\@
        add_piece
interval_next\@:
        next_piece
        IBXNE   pieces_left, minus_one_index, r0, interval_piece\@, pieces_left
        .endm

; hits0 = the field is at least T at the start of the interval.  hits1 = the
; Bernstein coefficients have both signs.
        .macro  begin_signs
        CMPLTV  [interval_end], big, [hits2]
        VTOV    r0, [interval_length] ?! [hits2]
        CMPGEV  [k0], r0, [hits0]
        XORB    [hits1], [hits1], [hits1]
        .endm

        .macro  signs_of k, differ
        CMPGEV  [\k], r0, [hits2]
        XORB    [hits0], [hits2], [hits2]
        ORB     [hits1], [hits2], [hits1]
        .endm

        no_code end_signs

; Computes the roots of the lanes of hits1, relative to interval_t.
        .macro  solve_interval
        VTOV    r0, [e5]
        VTOV    r0, [interval_length] ?! [hits1]
        solve_quartics solve_quartic_signs, e5, interval_length, sh6
        .endm

; Records the crossing [e0] of the lanes of hits1 as the only one.
        .macro  take_nearest
        SUBNV   [e0], [lane_along], [e0]
        VTOVX   [lane_at], [e0], [tin] ? [hits1]
        VTOVX   [lane_at], [e0], [tout] ? [hits1]
        VTOV    big, [interval_end] ? [hits1]
        .endm

; Appends the crossing [e0] of the lanes of hits1 if a column is free.
        .macro  take_crossing
        CMPLTV  r0, [columns_free], [hits2]
        ANDB    [hits1], [hits2], [hits2]
        SUBNV   [e0], [lane_along], [e0]
        VTOVX   [crossing_at], [e0], [tin] ? [hits2]
        EX      s2, CROSSING_SIZE
        ADDXV   [crossing_at], s2, [crossing_at] ? [hits2]
        SUBNV   [columns_free], one, [columns_free] ? [hits2]
        .endm

; hits1 = the lanes that cross at interval_t: inside by the previous interval
; and outside by this one, or vice versa.  The first interval has no
; predecessor.
        .macro  signs_at_beginning
        XORB    [lane_inside], [hits0], [hits1]
        IBXNE   nearest_interval, r0, one_index, signs_walked\@
        XORB    [hits1], [hits1], [hits1]
        ES      nearest_interval, 2
signs_walked\@:
        keep_where CMPLTV, [interval_t], big, hits1, hits2
        .endm

; lane_inside = inside at the end of the interval: inside at its start,
; exclusive or an odd number of roots.
        .macro  inside_at_end
        CMPEQV  [root_count], one, [hits1]
        XORB    [hits0], [hits1], [lane_inside]
        ADDN    one, two, s2
        CMPEQV  [root_count], s2, [hits1]
        XORB    [lane_inside], [hits1], [lane_inside]
        .endm

; ---- The routines

; Sets all segments to misses.
        .macro  clear_segments
        first_column
clear_segment:
        VTOV    big, [column_at]
        next_column
        VTOV    minus_big, [column_at]
        next_column
        next_segment clear_segment
        .endm

        .macro  enter_blob_solid
        clear_segments
        ES      nearest_interval, 0
        load_record P_SHAPE, 7, sh0
        .endm

        .macro  enter_blob
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        ES      nearest_interval, 1
        load_record P_SHAPE, 7, sh0
        .endm

; Selects the next lanes from the rays of bits0, which come near the blob: all
; of them, or, if QUEUE exceeds BLOB_LANES, those among the next BLOB_LANES rays
; of the queue.  m = the number of lanes, bits2 = the rays that remain.
        .macro  begin_lanes
        .if     QUEUE > BLOB_LANES
        ORB     [bits0], [bits0], [bits2]
        ES      lanes_end, 0
blob_more:
        IX      lanes_end, BLOB_LANES
        CMPLTV  [iota], lanes_end, [bits0]
        ANDB    [bits0], [bits2], [bits0]
        ANDNB   [bits2], [bits0], [bits2]
        if_none bits0, m, blob_done
        IBXEQ   nearest_interval, r0, r0, begin_lanes\@
        ES      nearest_interval, 1
begin_lanes\@:
        .endif
        take_lanes
        .endm

        .macro  end_lanes
        .if     QUEUE > BLOB_LANES
        CNTOB   [bits2], s0
        IBXNE   s0, r0, r0, blob_more
        .endif
        .endm

; Records the crossing at the interval's start and the roots.
        .macro  take_root number, root
        CMPLTV  \number, [root_count], [hits1]
        ADDNV   [interval_t], [\root], [e0]
        take_crossing
        .endm

        .macro  take_crossings
        VTOV    [interval_t], [e0]
        take_crossing
        take_root r0, root0
        take_root one, root1
        take_root two, root2
        ADDN    one, two, s3
        take_root s3, root3
        .endm

        .macro  take_first
        ADDNV   [interval_t], [root0], [e0]
        VTOV    [interval_t], [e0] ? [hits1]
        CMPLTV  r0, [root_count], [hits2]
        ORB     [hits1], [hits2], [hits1]
        take_nearest
        .endm

        .macro  walk_blob
        leave_lanes blob_done
blob_walk:
        next_interval
        test_interval blob_passed
        if_none hits1, s0, blob_passed
        solve_interval
        signs_at_beginning
        IBXNE   nearest_interval, r0, r0, blob_first
        take_crossings
        BIM     blob_ended
blob_first:
        take_first
blob_ended:
        inside_at_end
        BIM     blob_continue

; No root: the only possible crossing is at the interval's start.
blob_passed:
        signs_at_beginning
        ORB     [hits0], [hits0], [lane_inside]
        if_none hits1, s0, blob_continue
        VTOV    [interval_t], [e0]
        IBXNE   nearest_interval, r0, r0, blob_there
        take_crossing
        BIM     blob_continue
blob_there:
        take_nearest
blob_continue:
        VTOV    [interval_end], [interval_t]
        leave_lanes blob_done
        BIM     blob_walk
blob_done:
        end_lanes
blob_none:
blob_miss:
        BIM     0, link_kernel
        .endm
