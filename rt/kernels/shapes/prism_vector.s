; prism_vector.s - a queue of rays meets a prism: closed loops of edges in x and
; z, swept along y from one cap to the other.  What an odd number of loops runs
; round is inside.
;
; Seen along y a ray is a line.  Of each corner P, told from the origin o,
;
;   side = dx pz - dz px          which side of the line it is on
;   way  = dx px + dz pz          how far along it
;
; An edge from one corner to the next is crossed if one side is >= 0 and the
; other is not: so a line crosses each loop an even number of times, whatever
; is rounded.  It is crossed at
;
;   t = (way0 + (way1 - way0) side0 / (side0 - side1)) / (dx^2 + dz^2)
;
; The caps' planes leave low .. high of the ray (slab_vector.s).  It is inside
; at low if it crosses an odd number of edges before low.
;
; A ray along y, dx^2 + dz^2 < tiny^2, is looked at along x instead: inside for
; ever if it crosses an odd number of edges before 0, or never.
;
; prism, open_prism: the crossing that is met first: the least t beyond the
;   ray's least distance, or a cap, low or high, if the ray is inside there.
; prism_solid, open_prism_sides: all of them: each edge's crossings go into
;   columns that are kept in order, by exchanges.
;
; In:  ox oy oz dx dy dz lower, near long; the primitive's record and table, rows
;      of x, z, 1 if a loop begins there, and what its normal wants
;      (normal_prism_vector.s).
; Out: tin = tout = the crossing that is met first; a miss is big, minus_big.
;      prism_solid: P_SEGMENTS segments, of vectors one after another from tin
;      on; open_prism_sides: the crossings with the sides between the caps,
;      likewise; the last once more if their number is odd.
; Source: textbook (the crossings of a polygon are counted); derived here.

        .ifndef LANE_VECTORS
        .include "shapes/lanes_vector.s"
        .endif
        .ifndef SEGMENT_COLUMNS
        .include "shapes/columns_vector.s"
        .endif

; Of the lanes, all rays at hand, in the lanes' own vectors.
        .reg    way, lane_at
        .reg    way_before, lane_ox
        .reg    side, lane_oy
        .reg    side_before, lane_oz
        .reg    inverse, lane_dx
        .reg    path_dx, lane_dy
        .reg    path_dz, lane_dz
        .reg    edge_low, lane_along
        .reg    edge_high, lane_low
        .reg    cap_low, lane_high
        .reg    cap_high, k4
        .reg    from_x, k2
        .reg    from_z, k1
        .reg    path_work, column_work
        .share  hits
        .regs   r164, left, left_before, crossed, inside_low
        .endshare
        .reg    inside_high, bits2

; Of a row.
        .reg    row_at, s3
        .reg    here_x, s4
        .reg    here_z, s5
        .reg    begins, s6
        .reg    rows_left, s7

        .macro  begin_prism
        load_record P_SHAPE, 3, sh0
        VTOV    minus_big, [tin]
        VTOV    big, [tout]
        slab    oy, dy, sh0, sh1
        close_segment
        set_lanes near
        VTOV    [tin], [cap_low]
        VTOV    [tout], [cap_high]
        MPYSV   [dx], [dx], [inverse]
        MPYSV   [dz], [dz], [path_work]
        ADDNV   [path_work], [inverse], [inverse]
        MPYS    tiny, tiny, s0
        CMPLTV  [inverse], s0, [bits0]
        CNTOB   [bits0], s0
        IBXNE   s0, r0, r0, prism_upright\@
        RTOR    dx, path_dx
        RTOR    dz, path_dz
        RTOR    cap_low, edge_low
        RTOR    cap_high, edge_high
        BIM     prism_slanted\@
prism_upright\@:
        MASKV   one, [inverse], [inverse] ? [bits0]
        MASKV   one, [dx], [path_dx] ? [bits0]
        MASKV   r0, [dz], [path_dz] ? [bits0]
        CMPGEV  [cap_high], [cap_low], [bits1]
        ANDB    [bits0], [bits1], [bits1]
        MASKV   r0, [cap_low], [edge_low] ? [bits1]
        MASKV   r0, [cap_high], [edge_high] ? [bits1]
prism_slanted\@:
        DIVSV   one, [inverse], [inverse]
        XORB    [inside_low], [inside_low], [inside_low]
        XORB    [inside_high], [inside_high], [inside_high]
        .endm

; Where a corner lies, seen along the path: on its left, and how far along.
        .macro  see_corner x, z
        SUBNV   \x, [ox], [from_x]
        SUBNV   \z, [oz], [from_z]
        MPYSV   [path_dx], [from_z], [side]
        MPYSV   [path_dz], [from_x], [path_work]
        SUBNV   [side], [path_work], [side]
        MPYSV   [path_dx], [from_x], [way]
        MPYSV   [path_dz], [from_z], [path_work]
        ADDNV   [path_work], [way], [way]
        CMPGEV  [side], r0, [left]
        .endm

; The crossings with each edge, at [crossed_at] where [crossed], to found.
        .macro  walk_edges found
        load_field P_TABLE, row_at
        RTOR    sh2, rows_left
prism_row\@:
        ELEN    row_at, 3
        SWAP    [row_at], here_x, [r0]          ; and here_z, begins
        IX      row_at, 64 * PRISM_SIZE
        see_corner here_x, here_z
        CFPNE   begins, r0, prism_next\@
        XORB    [left], [left_before], [crossed]
        CNTOB   [crossed], s0
        IBXEQ   s0, r0, r0, prism_next\@
        SUBNV   [side_before], [side], [path_work]
        MASKV   [path_work], one, [path_work] ? [crossed]
        DIVSV   [side_before], [path_work], [crossed_at]
        SUBNV   [way], [way_before], [path_work]
        MPYSV   [path_work], [crossed_at], [crossed_at]
        ADDNV   [way_before], [crossed_at], [crossed_at]
        MPYSV   [crossed_at], [inverse], [crossed_at]
        \found
prism_next\@:
        trade   side, side_before
        trade   way, way_before
        trade   left, left_before
        SUBN    rows_left, one, rows_left
        CFPLT   r0, rows_left, prism_row\@
        .endm

; [inside] changes where an edge is crossed before [end].
        .macro  turn_before end, inside
        CMPLTV  [crossed_at], [\end], [bits0]
        ANDB    [bits0], [crossed], [bits0]
        XORB    [\inside], [bits0], [\inside]
        .endm

; bits0 and [bits] where a < b; or a >= b.
        .macro  and_less a, b, bits
        CMPLTV  [\a], [\b], [bits0]
        ANDB    [bits0], [\bits], [\bits]
        .endm

        .macro  and_not_less a, b, bits
        CMPGEV  [\a], [\b], [bits0]
        ANDB    [bits0], [\bits], [\bits]
        .endm

; The sides that are met first: tin.
        .macro  side_ahead
        and_not_less crossed_at, edge_low, crossed
        and_not_less edge_high, crossed_at, crossed
        and_less lower, crossed_at, crossed
        and_less crossed_at, tin, crossed
        VTOV    [crossed_at], [tin] ? [crossed]
        .endm

        .macro  side_or_cap_ahead
        turn_before edge_low, inside_low
        turn_before edge_high, inside_high
        side_ahead
        .endm

        .macro  cap_ahead inside, cap
        and_less lower, \cap, \inside
        and_less \cap, tin, \inside
        VTOV    [\cap], [tin] ? [\inside]
        .endm

; tout as tin, or a miss.
        .macro  leave_prism
        CMPLTV  [tin], big, [bits0]
        VTOV    minus_big, [tout]
        VTOV    [tin], [tout] ? [bits0]
        BIM     0, link_kernel
        .endm

        .kernel prism
prism:
        begin_prism
        VTOV    big, [tin]
        walk_edges side_or_cap_ahead
        cap_ahead inside_low, cap_low
        cap_ahead inside_high, cap_high
        leave_prism

open_prism:
        begin_prism
        VTOV    big, [tin]
        walk_edges side_ahead
        leave_prism

; Crossings between the caps; [inside_high] where their number is odd.
        .macro  between_caps
        CMPGEV  [edge_low], [crossed_at], [bits0]
        ANDB    [bits0], [crossed], [bits0]
        XORB    [inside_low], [bits0], [inside_low]
        and_less edge_low, crossed_at, crossed
        and_less crossed_at, edge_high, crossed
        XORB    [inside_high], [crossed], [inside_high]
        CNTOB   [crossed], s0
        IBXEQ   s0, r0, r0, between_none\@
        insert  crossed
between_none\@:
        .endm

        .macro  side_between
        and_not_less crossed_at, edge_low, crossed
        and_not_less edge_high, crossed_at, crossed
        CNTOB   [crossed], s0
        IBXEQ   s0, r0, r0, between_none\@
        insert  crossed
between_none\@:
        .endm

        .macro  insert_cap inside, cap
        CNTOB   [\inside], s0
        IBXEQ   s0, r0, r0, cap_none\@
        VTOV    [\cap], [crossed_at]
        insert  \inside
cap_none\@:
        .endm

prism_solid:
        begin_prism
        clear_columns
        walk_edges between_caps
        XORB    [inside_high], [inside_low], [inside_high]
        insert_cap inside_low, cap_low
        insert_cap inside_high, cap_high
        BIM     prism_fill

open_prism_sides:
        begin_prism
        clear_columns
        walk_edges side_between

prism_fill:
        leave_columns
        .endkernel
