; lathe_vector.s - a queue of rays meets a lathe: segments of a path in r and y,
; r >= 0, turned about the y axis; each sweeps a piece of a cone.
;
; A height of the axis amid the path is y = 0 here.  With the ray's origin moved
; to o, its closest approach to that point, and d its direction, the ray's
; distance from the axis is a hyperbola in r and y.  Of each corner (r, y) of the
; path: is it beyond the hyperbola, seen from the axis?
;
;   (r dy)^2 > (ox dy - oy dx + y dx)^2 + (oz dy - oy dz + y dz)^2
;
; What is beyond it is convex.  So a segment is crossed
;
;   once    if one of its corners is beyond and the other is not,
;   never   if both are: it is passed over,
;   twice or never if neither is.  Where the ray comes to the segment's heights
;           only outside of the cylinder about the path, never: passed over, too.
;
; A corner at whose height the ray is outside of that cylinder is not beyond.
; Where that is so of all rays of the queue nothing is worked out of it, and
; nothing of segments of such heights.
;
; A corner is decided once for both segments that have it, and one on the axis is
; never beyond: so a ray crosses a path that is closed, or goes from the axis to
; the axis, an even number of times, whatever is rounded.
;
; With  nr r + ny y = k  for the line of the segment, nr >= 0, nr^2 + ny^2 = 1:
;
;   e = k - ny oy     f = ny dy
;   a = nr^2 (dx^2 + dz^2) - f^2      b = nr^2 (ox dx + oz dz) + e f
;   c = nr^2 (ox^2 + oz^2) - e^2      root = nr sqrt(E)
;   E = (e dx + f ox)^2 + (e dz + f oz)^2 - nr^2 (ox dz - oz dx)^2
;
; a t^2 + 2 b t + c is the cone; b^2 - a c = nr^2 E, in which nothing large
; cancels where the line is nearly level.  The ray goes to the axis' side at
; t = (-b - root)/a and comes from there at (-b + root)/a, whatever the sign of a:
; as q/a or c/q, q = -(b + sign(b) root) (quadratic_vector.s).
;
; Once:  the one of these in whose sense the corners differ, cut to the heights
;        of the segment.
; Twice: if a > 0, E > 0 and their middle is between the heights, from the lower
;        one on:  (low - oy) a <= -b dy < (high - oy) a.
;
; lathe: the crossing that is met first.
; lathe_solid: the segments inside of the closed path; see columns_vector.s.
; open_lathe_crossings: the crossings, likewise; the last once more if their
;   number is odd.
;
; In:  ox oy oz dx dy dz lower, near long; the primitive's record and table.  The
;      rows behind those that are seen close the path (rt/shapes/lathe.c).
; Out: tin = tout = the crossing that is met first; a miss is big, minus_big.
;      lathe_solid: P_SEGMENTS segments, of vectors one after another from tin on;
;      open_lathe_crossings: as many pairs of crossings.
; Source: derived here; the project's notes on ray tracing, 0 and 4.2.

        .if     LATHES
        .ifndef LANE_VECTORS
        .include "shapes/lanes_vector.s"
        .endif
        .ifndef SEGMENT_COLUMNS
        .include "shapes/columns_vector.s"
        .endif

; Of the lanes, all rays at hand, in the lanes' own vectors: o is lane_ox ..
        .reg    rise_square, lane_dx            ; dy^2
        .reg    level_square, lane_dy           ; dx^2 + dz^2
        .reg    per_rise, lane_dz               ; 1 / dy
        .reg    level_way, lane_at              ; ox dx + oz dz
        .reg    from_axis, k4                   ; ox^2 + oz^2
        .reg    gap, k2                       ; (ox dz - oz dx)^2
        .reg    turn_x, k1                    ; ox dy - oy dx
        .reg    turn_z, e0                    ; oz dy - oy dz
        .reg    ray_low, lane_low               ; heights, within the cylinder
        .reg    ray_high, lane_high
        .reg    line_e, e1                      ; of a segment
        .reg    line_f, e2
        .reg    cone_a, e3
        .reg    cone_b, e4
        .reg    cone_c, e5
        .reg    cone_q, e6
        .share  hits
        .regs   r164, beyond, beyond_before, once, twice
        .endshare
        .reg    falling, bits2                  ; dy < 0

; Of a row.
        .share  shape
        .regs   r46, row_square, row_height, row_begins, row_low, row_high
        .regs   r51, row_rises, line_ny, line_k, line_nr2, line_nr
        .endshare
        .reg    segment_at, s3
        .reg    segments_left, s4
        .reg    queue_low, s5
        .reg    queue_high, s6

; The ray's heights where it is within the cylinder about the path: with h the
; root of  R^2 (dx^2 + dz^2) - (ox dz - oz dx)^2,
;   oy - (ox dx + oz dz +- h) dy / (dx^2 + dz^2)
; all of a ray along y; those of the queue.
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

; [beyond] of the row's corner.
        .macro  look_at_corner
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

; [once], and [twice] of those that may be; to passed_over if there are none.
        .macro  sort_rays passed_over
        XORB    [beyond], [beyond_before], [once]
        CMPGEV  [ray_high], row_low, [bits0]
        CMPGEV  row_high, [ray_low], [bits1]
        ANDB    [bits0], [bits1], [twice]
        ORB     [beyond], [beyond_before], [bits0]
        ANDNB   [twice], [bits0], [twice]
        ORB     [twice], [once], [bits0]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, \passed_over
        .endm

; E in [w0].
        .macro  meet_cone
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

; Those of [twice] that cross the segment itself; to passed_over if there are
; none, nor any [once].
        .macro  keep_twice passed_over
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
        IBXEQ   s0, r0, r0, \passed_over
        .endm

; q; [bits0] where b >= 0.
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

; [crossed_at] of [once].  Where the segment rises, [beyond] where the ray does
; says that the ray goes to the axis' side.
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

; [crossed_at] of [twice].
        .macro  cross_twice over, under
        MASKV   [\under], one, [w1] ? [twice]
        DIVSV   [\over], [w1], [crossed_at]
        SUBNV   [crossed_at], [lane_along], [crossed_at]
        .endm

; The crossings of rows rows, at [crossed_at] where [bits], to found bits.
        .macro  walk_segments rows, found
        load_field P_TABLE, segment_at
        RTOR    \rows, segments_left
segment\@:
        ELEN    segment_at, 10
        SWAP    [segment_at], row_square, [r0]
        IX      segment_at, 64 * LATHE_SIZE
        CFPLT   row_height, queue_low, corner_far\@
        CFPLT   queue_high, row_height, corner_far\@
        look_at_corner
        BIM     corner_known\@
corner_far\@:
        XORB    [beyond], [beyond], [beyond]
corner_known\@:
        CFPNE   row_begins, r0, segment_passed\@
        CFPLT   row_high, queue_low, segment_passed\@
        CFPLT   queue_high, row_low, segment_passed\@
        sort_rays segment_passed\@
        meet_cone
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

; The crossings that are met first: tin.
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
        clear_columns
        begin_lathe lathe_filled
        walk_segments sh4, insert
        BIM     lathe_filled

open_lathe_crossings:
        clear_columns
        begin_lathe lathe_filled
        walk_segments sh3, insert
lathe_filled:
        leave_columns
        .endkernel
        .endif
