; blob_vector.s - intersects a queue of rays with a blob: the surface on which
; the sum of the fields of its components is T.
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
; A ray misses if the sum of the maxima of its pieces is below T.  Finished rays
; are removed by compression when they are more than half of the lanes.
;
; In:  ox oy oz dx dy dz lower, near long; the primitive's record and table.
; Out: tin = tout = the nearest crossing; a miss is big, minus_big.
;      blob_solid: P_SEGMENTS segments in successive vectors from tin on.
; Source: the field: POV-Ray's manual, 3.7; the walk: derived here.

        .if     BLOB_PIECES

        include_form lanes
; Vectors, one word per lane: start, end and length of the current interval, the
; sum of the maxima of the pieces; for solids the index of the next crossing in
; the columns, and the number of free columns.
        .share  scratch
        .regs   r233, interval_t, interval_end, interval_length, most_field, crossing_at, columns_free
        .equ    BLOB_VECTORS, 6
        .regs   r239, piece_a, piece_b, piece_c, piece_enter, piece_leave
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
        .include "shapes/blob_terms.s"

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

; ---- The pieces

        .macro  next_vector before, vector
        RTOR    \before, \vector
        IX      \vector, 64 * BLOB_LANES
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
        IX      piece_a, 64 * PIECE_SIZE
        IX      piece_b, 64 * PIECE_SIZE
        IX      piece_c, 64 * PIECE_SIZE
        IX      piece_enter, 64 * PIECE_SIZE
        IX      piece_leave, 64 * PIECE_SIZE
        IX      strength_at, 64
        .endm

; Computes the interval [from] .. [to] in which [a] t^2 + 2 [b] t - [c] is below
; 0, for a > 0.  hits0 = the lanes that have one.  Changes disc (the
; discriminant) and root.
        .macro  reach_of a, b, c, inverse, from, to, disc, root
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

; Stores the interval [from] .. [to] of the lanes of hits0 as a piece and lowers
; interval_t to its start.  hits1 = the lanes that have it ahead of them.  Branches
; to none if there are none.
        .macro  take_piece from, to, none
        CMPLTV  [\from], [\to], [hits1]
        ANDB    [hits0], [hits1], [hits1]
        CMPLTV  [lane_low], [\to], [hits2]
        ANDB    [hits1], [hits2], [hits1]
        CNTOB   [hits1], s0
        IBXEQ   s0, r0, r0, \none
        MASKV   [\from], big, [piece_enter] ? [hits1]
        MASKV   [\to], big, [piece_leave] ? [hits1]
        CMPLTV  [\from], [interval_t], [hits2]
        ANDB    [hits1], [hits2], [hits2]
        VTOV    [\from], [interval_t] ? [hits2]
        STO     [strength_at], sh14
        IX      pieces_used, 1
        .endm

; Adds the maximum of a piece, strength [g]^2, in the lanes of bits.
        .macro  add_most g, bits
        CFPGE   r0, sh14, add_most\@
        MPYSV   [\g], [\g], [\g]
        MPYSV   [\g], sh14, [\g]
        ADDNV   [most_field], [\g], [most_field] ? [\bits]
add_most\@:
        .endm

; Adds the piece of a ball: centre sh9-sh11, sh12 = r^2, sh13 = 1/r^2.
        .macro  take_ball
        SUBNV   [lane_ox], sh9, [e0]
        SUBNV   [lane_oy], sh10, [e1]
        SUBNV   [lane_oz], sh11, [e2]
        dot_vectors e0, e1, e2, lane_dx, lane_dy, lane_dz, e3, e4
        dot_vectors e0, e1, e2, e0, e1, e2, e5, e4
        SUBNV   sh12, [e5], [e5]
        MPYSV   [e3], [e3], [e6]
        ADDNV   [e6], [e5], [e6]
        CMPLTV  r0, [e6], [hits0]
        SQRTV   [e6], [e7] ? [hits0]
        ADDNV   [e3], [e7], [e8]
        SUBNV   r0, [e8], [e8]
        SUBNV   [e7], [e3], [e9]
        take_piece e8, e9, blob_next_row
        SUBN    r0, sh13, s2
        VTOV    s2, [piece_a]
        MPYSV   [e3], s2, [piece_b]
        MPYSV   [e5], sh13, [piece_c]
        MPYSV   [e6], sh13, [e10]
        add_most e10, hits1
        next_piece
        .endm

; [x], [d] = the ray's origin and direction along one axis of the part's space.
        .macro  part_axis m0, m1, m2, m3, x, d
        dot_constant lane_ox, lane_oy, lane_oz, \m0, \m1, \m2, \x, e12
        ADDNV   [\x], \m3, [\x]
        dot_constant lane_dx, lane_dy, lane_dz, \m0, \m1, \m2, \d, e12
        .endm

; The ray in the part's space: origin e0-e2, direction e3-e5.
        .macro  part_axes
        part_axis m00, m01, m02, m03, e0, e3
        part_axis m10, m11, m12, m13, e1, e4
        part_axis m20, m21, m22, m23, e2, e5
        .endm

; Stores the coefficients of a piece: those of the quadratic with the sign of g.
        .macro  put_piece a, b, c
        VTOV    -[\a], [piece_a]
        VTOV    -[\b], [piece_b]
        VTOV    [\c], [piece_c]
        .endm

        .macro  take_ellipsoid
        part_axes
        dot_vectors e3, e4, e5, e3, e4, e5, e6, e12
        dot_vectors e0, e1, e2, e3, e4, e5, e7, e12
        dot_vectors e0, e1, e2, e0, e1, e2, e8, e12
        SUBNV   one, [e8], [e8]
        DIVSV   one, [e6], [e9]
        reach_of e6, e7, e8, e9, e0, e1, e2, e3
        take_piece e0, e1, blob_next_row
        put_piece e6, e7, e8
        MPYSV   [e2], [e9], [e2]
        add_most e2, hits1
        next_piece
        .endm

; first_at, last_at = where the ray crosses the planes of the first and of the
; second end on its way; first_z, last_z = the height of the origin above these
; ends.  A ray parallel to the planes stays on one side of each: its crossings
; are big or minus_big.
        .macro  find_ends
        SUBNV   [e2], sh15, [cap_z]
        CMPLTV  |[e5]|, tiny, [hits0]
        CMPLTV  [e5], r0, [hits1]
        ANDNB   [hits1], [hits0], [hits1]
        MASKV   one, [e5], [e6] ? [hits0]
        DIVSV   one, [e6], [e6]
        MASKV   [cap_z], [e2], [first_z] ? [hits1]
        MASKV   [e2], [cap_z], [last_z] ? [hits1]
        MPYSV   -[first_z], [e6], [first_at]
        MPYSV   -[last_z], [e6], [last_at]
        CNTOB   [hits0], s0
        IBXEQ   s0, r0, r0, find_ends\@
        VTOV    minus_big, [first_at] ? [hits0]
        VTOV    big, [last_at] ? [hits0]
        CMPLTV  [e2], r0, [hits1]
        ANDB    [hits0], [hits1], [hits1]
        VTOV    big, [first_at] ? [hits1]
        CMPLTV  r0, [cap_z], [hits1]
        ANDB    [hits0], [hits1], [hits1]
        VTOV    minus_big, [last_at] ? [hits1]
find_ends\@:
        .endm

        .macro  rise_to low, x
        CMPLTV  [\x], [\low], [hits1]
        VTOV    [\low], [\x] ? [hits1]
        .endm

        .macro  sink_to high, x
        CMPLTV  [\high], [\x], [hits1]
        VTOV    [\high], [\x] ? [hits1]
        .endm

; Adds the piece between the planes: e6 t^2 + 2 e7 t - e8 is the squared
; distance from the axis, minus 1.  A ray along the axis is near it everywhere
; or nowhere.  Branches to blob_next_row if no ray comes near the axis, for then
; none comes near the ends.
        .macro  take_side
        MPYSV   [e3], [e3], [e6]
        MPYSV   [e4], [e4], [e12]
        ADDNV   [e12], [e6], [e6]
        MPYSV   [e0], [e3], [e7]
        MPYSV   [e1], [e4], [e12]
        ADDNV   [e12], [e7], [e7]
        MPYSV   [e0], [e0], [e8]
        MPYSV   [e1], [e1], [e12]
        ADDNV   [e12], [e8], [e8]
        SUBNV   one, [e8], [e8]
        MPYS    tiny, tiny, s2
        CMPLTV  [e6], s2, [hits2]
        MASKV   one, [e6], [e9] ? [hits2]
        DIVSV   one, [e9], [e9]
        reach_of e6, e7, e8, e9, e0, e1, e3, e4
        CNTOB   [hits2], s0
        IBXEQ   s0, r0, r0, side_crossed
        VTOV    [e8], [e3] ? [hits2]
        CMPLTV  r0, [e3], [hits0]
        VTOV    minus_big, [e0] ? [hits2]
        VTOV    big, [e1] ? [hits2]
side_crossed:
        CNTOB   [hits0], s0
        IBXEQ   s0, r0, r0, blob_next_row
        MPYSV   [e3], [e9], [e3]
        add_most e3, hits0
        rise_to first_at, e0
        sink_to last_at, e1
        take_piece e0, e1, side_none
        put_piece e6, e7, e8
        next_piece
side_none:
        .endm

; Computes the interval in the half ball at one end: e3 t^2 + 2 e0 t - e1 is the
; squared distance from that end, minus 1.
        .macro  reach_of_end z
        MPYSV   [\z], [e5], [e0]
        ADDNV   [e0], [e7], [e0]
        MPYSV   [\z], [\z], [e1]
        SUBNV   [e8], [e1], [e1]
        reach_of e3, e0, e1, e4, e9, e10, e11, e12
        .endm

        .macro  take_end
        take_piece e9, e10, end_none\@
        put_piece e3, e0, e1
        next_piece
end_none\@:
        .endm

        .macro  take_cylinder
        part_axes
        find_ends
        take_side
        MPYSV   [e5], [e5], [e3]
        ADDNV   [e3], [e6], [e3]
        DIVSV   one, [e3], [e4]
        reach_of_end first_z
        sink_to first_at, e10
        take_end
        reach_of_end last_z
        rise_to last_at, e9
        take_end
        .endm

; Stores the pieces of all components.  Sets interval_t, where the walk starts: at
; the lower limit or at the first entry into a piece, whichever is later.
        .macro  take_pieces
        set_blob_lanes
        first_piece
        VTOV    big, [interval_t]
        VTOV    r0, [most_field]
        ES      pieces_used, 0
        load_field P_TABLE, blob_row
        RTOR    sh5, blob_rows_left
blob_part:
        ELEN    blob_row, 7
        SWAP    [blob_row], sh8, [r0]
        CFPNE   sh8, r0, blob_moved
        take_ball
        BIM     blob_next_row
blob_moved:
        RTOR    blob_row, s2
        IX      s2, 64 * BLOB_LENGTH
        ELEN    s2, 13
        SWAP    [s2], sh15, [r0]                ; also m00 .. m23
        CFPNE   sh8, one, blob_long
        take_ellipsoid
        BIM     blob_next_row
blob_long:
        take_cylinder
blob_next_row:
        IX      blob_row, 64 * BLOB_SIZE
        SUBN    blob_rows_left, one, blob_rows_left
        CFPLT   r0, blob_rows_left, blob_part
        CMPLTV  [most_field], sh4, [hits0]
        VTOV    big, [interval_t] ? [hits0]
        rise_to lane_low, interval_t
        VTOV    [lane_at], [crossing_at]
        load_field P_SEGMENTS, s2
        ADDN    s2, s2, s2
        VTOV    s2, [columns_free]
        XORB    [lane_inside], [lane_inside], [lane_inside]
        .endm

; ---- The walk

; Compresses a vector of a piece in place and restores the register's length.
        .macro  keep_vector vector
        CPSV    [\vector], [\vector] ? [hits1]
        lengthen m, \vector
        .endm

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
        keep_vector piece_a
        keep_vector piece_b
        keep_vector piece_c
        keep_vector piece_enter
        keep_vector piece_leave
        next_piece
        IBXNE   pieces_left, minus_one_index, r0, keep_piece\@, pieces_left
        CNTOB   [hits1], m
        set_blob_lanes
        .endm

; Branches to none if every lane has finished its walk.  Removes the finished
; lanes if they are more than half.
        .macro  leave_lanes none
        CMPLTV  [interval_t], big, [hits1]
        CNTOB   [hits1], s0
        IBXEQ   s0, r0, r0, \none
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
        CNTOB   [hits1], s0
        IBXEQ   s0, r0, r0, interval_next\@
        CMPLTV  [interval_t], [piece_enter], [hits0]
        MASKV   [piece_enter], [piece_leave], [e0] ? [hits0]
        CMPLTV  [e0], [interval_end], [hits2]
        ANDB    [hits1], [hits2], [hits2]
        VTOV    [e0], [interval_end] ? [hits2]
        ANDNB   [hits1], [hits0], [hits1]
        CNTOB   [hits1], s0
        IBXEQ   s0, r0, r0, interval_next\@
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

        .macro  end_signs differ, alike
        .endm

; Computes the roots of the lanes of hits1, relative to interval_t.
        .macro  solve_interval
        VTOV    r0, [e5]
        VTOV    r0, [interval_length] ?! [hits1]
        RTOR    link_inner, lane_link
        EX      target, solve_quartic_signs
        call_quartic target, k4, k3, k2, k1, k0, e5, interval_length, sh6
        RTOR    lane_link, link_inner
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

; hits1 = the lanes that cross at interval_t: inside by the previous interval and
; outside by this one, or vice versa.  The first interval has no predecessor.
        .macro  signs_at_beginning
        XORB    [lane_inside], [hits0], [hits1]
        IBXNE   nearest_interval, r0, one_index, signs_walked\@
        XORB    [hits1], [hits1], [hits1]
        ES      nearest_interval, 2
signs_walked\@:
        CMPLTV  [interval_t], big, [hits2]
        ANDB    [hits1], [hits2], [hits1]
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

        .macro  begin_blob
        load_record P_SHAPE, 7, sh0
        SUBNV   [ox], sh0, [w8]
        SUBNV   [oy], sh1, [w9]
        SUBNV   [oz], sh2, [w10]
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
        CNTOB   [bits0], m
        IBXEQ   m, r0, r0, blob_done
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

        .kernel blob
blob_solid:
        clear_segments
        ES      nearest_interval, 0
        begin_blob
        find_all_lanes w8, w9, w10, sh3, blob_missed
        BIM     blob_lanes
blob:
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        ES      nearest_interval, 1
        begin_blob
        find_lanes w8, w9, w10, sh3, blob_missed
blob_lanes:
        begin_lanes
        take_pieces
        EX      s2, blob_numbers
        ELEN    s2, 3
        SWAP    [s2], blob_quarter, [r0]        ; also blob_sixth, blob_four
        leave_lanes blob_done
blob_walk:
        next_interval
        test_interval blob_passed
        CNTOB   [hits1], s0
        IBXEQ   s0, r0, r0, blob_passed
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
        CNTOB   [hits1], s0
        IBXEQ   s0, r0, r0, blob_continue
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
blob_missed:
        BIM     0, link_kernel
        .endkernel

        .endif
