; lathe_vector.s - intersects a queue of rays with a lathe: the segments of a
; path in r and y, r >= 0, turned about the y axis.  Each sweeps a piece of a
; cone.
;
; y = 0 is a height within the path.  o is the ray's closest approach to that
; point of the axis and d its direction.  In r and y a ray is a hyperbola.  A
; corner (r, y) of the path is beyond the hyperbola, seen from the axis, if
;
;   (r dy)^2 > (ox dy - oy dx + y dx)^2 + (oz dy - oy dz + y dz)^2
;
; The region beyond it is convex.  So a segment is crossed
;
;   once            if one of its corners is beyond and the other is not;
;   never           if both are: it is skipped;
;   twice or never  if neither is.  It is also skipped if the ray reaches its
;                   heights only outside the cylinder that bounds the path.
;
; A corner at a height at which the ray is outside that cylinder is not beyond.
; If this is so for all rays of the queue, nothing is computed for the corner,
; and nothing for segments at such heights.
;
; A corner is decided once for both its segments, and a corner on the axis is
; never beyond.  So a ray crosses a path that is closed, or that begins and ends
; on the axis, an even number of times, independently of rounding.
;
; The line of the segment is  nr r + ny y = k,  nr >= 0, nr^2 + ny^2 = 1:
;
;   e = k - ny oy     f = ny dy
;   a = nr^2 (dx^2 + dz^2) - f^2      b = nr^2 (ox dx + oz dz) + e f
;   c = nr^2 (ox^2 + oz^2) - e^2      root = nr sqrt(E)
;   E = (e dx + f ox)^2 + (e dz + f oz)^2 - nr^2 (ox dz - oz dx)^2
;
; The cone is a t^2 + 2 b t + c = 0, with b^2 - a c = nr^2 E.  In E nothing
; large cancels if the line is nearly level.  For either sign of a the ray
; crosses to the axis' side at t = (-b - root)/a and back at (-b + root)/a.
; These are q/a and c/q with q = -(b + sign(b) root) (form_vector.s).
;
; Once:  the root whose side the corners show, clamped to the heights of the
;        segment.
; Twice: both roots if a > 0, E > 0 and their middle is between the heights, the
;        lower one included:  (low - oy) a <= -b dy < (high - oy) a.
;
; lathe: the nearest crossing ahead.
; lathe_solid: the segments inside the closed path (columns_vector.s).
; open_lathe_crossings: the crossings, in the same columns; the last one is
;   repeated if their number is odd.
;
; In:  ox oy oz dx dy dz lower, near long; the primitive's record and table.
;      The rows after those of the visible surface close the path
;      (rt/shapes/lathe.c).
; Out: tin = tout = the nearest crossing ahead; a miss is big, minus_big.
;      lathe_solid: P_SEGMENTS segments in successive vectors from tin on;
;      open_lathe_crossings: P_SEGMENTS pairs of crossings.
; Source: derived here; the project's notes on ray tracing, 0 and 4.2.

        .if     LATHES
        .ifndef LANE_VECTORS
        .include "shapes/lanes_vector.s"
        .endif
        .ifndef SEGMENT_COLUMNS
        .include "shapes/columns_vector.s"
        .endif

; One word per near ray, in the vectors of the lanes.  o is lane_ox, lane_oy,
; lane_oz.
        .reg    rise_square, lane_dx            ; dy^2
        .reg    level_square, lane_dy           ; dx^2 + dz^2
        .reg    per_rise, lane_dz               ; 1 / dy
        .reg    level_way, lane_at              ; ox dx + oz dz
        .reg    from_axis, k4                   ; ox^2 + oz^2
        .reg    gap, k2                       ; (ox dz - oz dx)^2
        .reg    turn_x, k1                    ; ox dy - oy dx
        .reg    turn_z, e0                    ; oz dy - oy dz
        .reg    ray_low, lane_low               ; heights within the cylinder
        .reg    ray_high, lane_high
        .reg    line_e, e1                      ; of the segment
        .reg    line_f, e2
        .reg    cone_a, e3
        .reg    cone_b, e4
        .reg    cone_c, e5
        .reg    cone_q, e6
        .share  hits
        .regs   r164, beyond, beyond_before, once, twice
        .endshare
        .reg    falling, bits2                  ; dy < 0

; The words of a row.
        .share  shape
        .regs   r46, row_square, row_height, row_begins, row_low, row_high
        .regs   r51, row_rises, line_ny, line_k, line_nr2, line_nr
        .endshare
        .reg    segment_at, s3
        .reg    segments_left, s4
        .reg    queue_low, s5
        .reg    queue_high, s6

; Computes the heights of each ray within the cylinder that bounds the path.
; With h = sqrt(R^2 (dx^2 + dz^2) - (ox dz - oz dx)^2) they are
;   oy - (ox dx + oz dz +- h) dy / (dx^2 + dz^2),
; or all heights for a ray parallel to y.  queue_low, queue_high = the range of
; all rays.  Branches to miss if that is outside the path.
        .macro  heights_within miss
        LINKV
        MPYSV   [level_square], sh1, [w0]
        SUBNV   [w0], [gap], [w0]
        CMPLTV  [w0], r0, [bits0]
        VTOV    r0, [w0] ? [bits0]
        SQRTV   [w0], [w0]
        CMPEQV  [level_square], r0, [bits1]
        MASKV   one, [level_square], [w1] ? [bits1]
        DIVSV   [dy], [w1], [w1]
        ADDNV   [level_way], [w0], [w2]
        MPYSV   [w2], [w1], [w2]
        SUBNV   [lane_oy], [w2], [w2]
        SUBNV   [level_way], [w0], [w3]
        MPYSV   [w3], [w1], [w3]
        SUBNV   [lane_oy], [w3], [w3]
        MASKV   [w3], [w2], [ray_low] ? [falling]
        MASKV   [w2], [w3], [ray_high] ? [falling]
        SUBN    r0, sh2, s7
        VTOV    s7, [ray_low] ? [bits1]
        VTOV    sh2, [ray_high] ? [bits1]
        VTOV    big, [ray_low] ? [bits0]
        VTOV    minus_big, [ray_high] ? [bits0]
        MINV    [ray_low], s0, queue_low
        MAXV    [ray_high], s0, queue_high
        CFPLT   queue_high, s7, \miss
        CFPLT   sh2, queue_low, \miss
        .endm

        .macro  begin_lathe miss
        load_record P_SHAPE, 5, sh0
        set_lanes near
        SUBNV   [oy], sh0, [w1]
        closest_approach ox, w1, oz, lane_ox, lane_oy, lane_oz, lane_along, w3
        MPYSV   [dy], [dy], [rise_square]
        MPYSV   [dx], [dx], [level_square]
        MPYSV   [dz], [dz], [w0]
        ADDNV   [w0], [level_square], [level_square]
        MPYSV   [lane_ox], [dx], [level_way]
        MPYSV   [lane_oz], [dz], [w0]
        ADDNV   [w0], [level_way], [level_way]
        MPYSV   [lane_ox], [lane_ox], [from_axis]
        MPYSV   [lane_oz], [lane_oz], [w0]
        ADDNV   [w0], [from_axis], [from_axis]
        MPYSV   [lane_ox], [dz], [gap]
        MPYSV   [lane_oz], [dx], [w0]
        SUBNV   [gap], [w0], [gap]
        MPYSV   [gap], [gap], [gap]
        CMPLTV  [dy], r0, [falling]
        heights_within \miss
        MPYSV   [lane_ox], [dy], [turn_x]
        MPYSV   [lane_oy], [dx], [w0]
        SUBNV   [turn_x], [w0], [turn_x]
        MPYSV   [lane_oz], [dy], [turn_z]
        MPYSV   [lane_oy], [dz], [w0]
        SUBNV   [turn_z], [w0], [turn_z]
        CMPEQV  [dy], r0, [bits0]
        MASKV   one, [dy], [per_rise] ? [bits0]
        DIVSV   one, [per_rise], [per_rise]
        .endm

; [beyond] = the row's corner is beyond the hyperbola.
        .macro  find_corner_side
        LINKV
        MPYSV   [dx], row_height, [w0]
        ADDNV   [w0], [turn_x], [w0]
        LINKV
        MPYSV   [dz], row_height, [w1]
        ADDNV   [w1], [turn_z], [w1]
        MPYSV   [w0], [w0], [w0]
        MPYSV   [w1], [w1], [w1]
        ADDNV   [w1], [w0], [w0]
        LINKV
        MPYSV   [rise_square], row_square, [w1]
        CMPLTV  [w0], [w1], [beyond]
        CMPGEV  row_height, [ray_low], [bits0]
        CMPGEV  [ray_high], row_height, [bits1]
        ANDB    [bits0], [beyond], [beyond]
        ANDB    [bits1], [beyond], [beyond]
        .endm

; [once] = the rays that cross the segment once, [twice] = those that may cross
; it twice.  Branches to missed if both are empty.
        .macro  sort_rays missed
        XORB    [beyond], [beyond_before], [once]
        CMPGEV  [ray_high], row_low, [bits0]
        CMPGEV  row_high, [ray_low], [bits1]
        ANDB    [bits0], [bits1], [twice]
        ORB     [beyond], [beyond_before], [bits0]
        ANDNB   [twice], [bits0], [twice]
        ORB     [twice], [once], [bits0]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, \missed
        .endm

; Computes the coefficients of the segment's cone, and [w0] = E.
        .macro  intersect_cone
        LINKV
        MPYSV   [lane_oy], line_ny, [line_e]
        SUBNV   line_k, [line_e], [line_e]
        MPYSV   [dy], line_ny, [line_f]
        MPYSV   [line_e], [dx], [w0]
        MPYSV   [line_f], [lane_ox], [w1]
        ADDNV   [w1], [w0], [w0]
        MPYSV   [line_e], [dz], [w1]
        MPYSV   [line_f], [lane_oz], [w2]
        ADDNV   [w2], [w1], [w1]
        MPYSV   [w0], [w0], [w0]
        MPYSV   [w1], [w1], [w1]
        ADDNV   [w1], [w0], [w0]
        LINKV
        MPYSV   [gap], line_nr2, [w1]
        SUBNV   [w0], [w1], [w0]
        MPYSV   [line_f], [line_f], [w1]
        LINKV
        MPYSV   [level_square], line_nr2, [w2]
        SUBNV   [w2], [w1], [cone_a]
        MPYSV   [line_e], [line_f], [w1]
        LINKV
        MPYSV   [level_way], line_nr2, [w2]
        ADDNV   [w2], [w1], [cone_b]
        MPYSV   [line_e], [line_e], [w1]
        LINKV
        MPYSV   [from_axis], line_nr2, [w2]
        SUBNV   [w2], [w1], [cone_c]
        .endm

; Keeps the rays of [twice] that cross the segment itself.  Branches to
; missed if [twice] and [once] are empty.
        .macro  keep_twice missed
        CMPLTV  r0, [w0], [bits0]
        ANDB    [bits0], [twice], [twice]
        CMPLTV  r0, [cone_a], [bits0]
        ANDB    [bits0], [twice], [twice]
        CNTOB   [twice], s0
        IBXEQ   s0, r0, r0, none_twice\@
        MPYSV   [cone_b], [dy], [w1]
        LINKV
        SUBNV   row_low, [lane_oy], [w2]
        MPYSV   [w2], [cone_a], [w2]
        CMPGEV  -[w1], [w2], [bits0]
        ANDB    [bits0], [twice], [twice]
        LINKV
        SUBNV   row_high, [lane_oy], [w2]
        MPYSV   [w2], [cone_a], [w2]
        CMPLTV  -[w1], [w2], [bits0]
        ANDB    [bits0], [twice], [twice]
none_twice\@:
        ORB     [twice], [once], [bits0]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, \missed
        .endm

; Computes q.  [bits0] = b >= 0.
        .macro  solve_cone
        CMPLTV  [w0], r0, [bits0]
        VTOV    r0, [w0] ? [bits0]
        LINKV
        SQRTV   [w0], [w0]
        MPYSV   [w0], line_nr, [w0]
        ADDNV   |[cone_b]|, [w0], [cone_q]
        CMPGEV  [cone_b], r0, [bits0]
        VTOV    -[cone_q], [cone_q] ? [bits0]
        .endm

; Computes [crossed_at] of the rays of [once].  If the segment rises, a ray that
; rises goes to the axis' side exactly if its upper corner is beyond.
        .macro  cross_once
        XORB    [beyond], [falling], [bits1]
        XORB    [bits1], [bits0], [bits1]
        CFPEQ   row_rises, r0, once_falls\@
        MASKV   [cone_c], [cone_q], [crossed_at] ? [bits1]
        MASKV   [cone_q], [cone_a], [w1] ? [bits1]
        BIM     once_chosen\@
once_falls\@:
        MASKV   [cone_q], [cone_c], [crossed_at] ? [bits1]
        MASKV   [cone_a], [cone_q], [w1] ? [bits1]
once_chosen\@:
        CMPEQV  [w1], r0, [bits1]
        VTOV    one, [w1] ? [bits1]
        DIVSV   [crossed_at], [w1], [crossed_at]
        LINKV
        SUBNV   row_low, [lane_oy], [w1]
        MPYSV   [w1], [per_rise], [w1]
        LINKV
        SUBNV   row_high, [lane_oy], [w2]
        MPYSV   [w2], [per_rise], [w2]
        MASKV   [w2], [w1], [w3] ? [falling]
        CMPLTV  [crossed_at], [w3], [bits1]
        VTOV    [w3], [crossed_at] ? [bits1]
        MASKV   [w1], [w2], [w3] ? [falling]
        CMPLTV  [w3], [crossed_at], [bits1]
        VTOV    [w3], [crossed_at] ? [bits1]
        SUBNV   [crossed_at], [lane_along], [crossed_at]
        .endm

; Computes [crossed_at] of the rays of [twice] as over / under.
        .macro  cross_twice over, under
        MASKV   [\under], one, [w1] ? [twice]
        DIVSV   [\over], [w1], [crossed_at]
        SUBNV   [crossed_at], [lane_along], [crossed_at]
        .endm

; Computes the crossings with the first `rows` rows; found uses [crossed_at] in
; the lanes of bits.
        .macro  walk_segments rows, found
        load_field P_TABLE, segment_at
        RTOR    \rows, segments_left
segment\@:
        ELEN    segment_at, 10
        SWAP    [segment_at], row_square, [r0]
        IX      segment_at, 64 * LATHE_SIZE
        CFPLT   row_height, queue_low, corner_far\@
        CFPLT   queue_high, row_height, corner_far\@
        find_corner_side
        BIM     corner_known\@
corner_far\@:
        XORB    [beyond], [beyond], [beyond]
corner_known\@:
        CFPNE   row_begins, r0, segment_passed\@
        CFPLT   row_high, queue_low, segment_passed\@
        CFPLT   queue_high, row_low, segment_passed\@
        sort_rays segment_passed\@
        intersect_cone
        keep_twice segment_passed\@
        solve_cone
        CNTOB   [once], s0
        IBXEQ   s0, r0, r0, segment_twice\@
        cross_once
        \found  once
segment_twice\@:
        CNTOB   [twice], s0
        IBXEQ   s0, r0, r0, segment_passed\@
        cross_twice cone_q, cone_a
        \found  twice
        cross_twice cone_c, cone_q
        \found  twice
segment_passed\@:
        trade   beyond, beyond_before
        SUBN    segments_left, one, segments_left
        CFPLT   r0, segments_left, segment\@
        .endm

; tin = the nearest crossings ahead.
        .macro  crossed_ahead bits
        CMPLTV  [lower], [crossed_at], [bits0]
        ANDB    [bits0], [\bits], [bits1]
        CMPLTV  [crossed_at], [tin], [bits0]
        ANDB    [bits0], [bits1], [bits1]
        VTOV    [crossed_at], [tin] ? [bits1]
        .endm

        .kernel lathe
lathe:
        begin_lathe lathe_miss
        VTOV    big, [tin]
        walk_segments sh3, crossed_ahead
        CMPLTV  [tin], big, [bits0]
        VTOV    minus_big, [tout]
        VTOV    [tin], [tout] ? [bits0]
        BIM     0, link_kernel
lathe_miss:
        miss_all

lathe_solid:
        begin_columns
        begin_lathe lathe_filled
        walk_segments sh4, insert
        BIM     lathe_filled

open_lathe_crossings:
        begin_columns
        begin_lathe lathe_filled
        walk_segments sh3, insert
lathe_filled:
        leave_columns
        .endkernel
        .endif
