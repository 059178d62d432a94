; prism_vector.s - intersects a queue of rays with a prism: closed loops of
; edges in x and z, swept along y from one cap to the other.  A point is inside
; if an odd number of loops surrounds it.
;
; Seen along y a ray is a line.  For each corner P, relative to the origin o,
;
;   side = dx pz - dz px          the side of the line on which it is
;   along_path = dx px + dz pz    its position along the line
;
; An edge from one corner to the next is crossed if exactly one of their sides
; is >= 0.  So a line crosses each loop an even number of times, independently
; of rounding.  The crossing is at
;
;   t = (way0 + (way1 - way0) side0 / (side0 - side1)) / (dx^2 + dz^2)
;
; The planes of the caps cut the ray to low .. high (slab_vector.s).  It is
; inside at low if it crosses an odd number of edges before low.
;
; A ray along y, dx^2 + dz^2 < tiny^2, is replaced by one along x: it is inside
; everywhere if that crosses an odd number of edges before 0, else nowhere.
;
; prism, open_prism: the nearest crossing: the smallest t beyond the lower
;   limit, or a cap, low or high, if the ray is inside there.
; prism_solid, open_prism_sides: all crossings, sorted into columns
;   (columns_vector.s).
;
; In:  ox oy oz dx dy dz lower, near long; the primitive's record and table,
;      rows of x, z, 1 if a loop begins there, and the data of its normal
;      (normal_prism.s).
; Out: tin = tout = the nearest crossing; a miss is big, minus_big.
;      prism_solid: P_SEGMENTS segments in successive vectors from tin on;
;      open_prism_sides: the crossings with the sides between the caps, in the
;      same vectors; the last one is repeated if their number is odd.
; Source: textbook (the crossings of a polygon are counted); derived here.

        .ifndef LANE_VECTORS
        .include "shapes/lanes_vector.s"
        .endif
        .ifndef SEGMENT_COLUMNS
        .include "shapes/columns_vector.s"
        .endif

; One word per near ray, in the vectors of the lanes.
        .reg    along_path, lane_at
        .reg    along_path_before, lane_ox
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

; The words of a row.
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

; Computes side, left (side >= 0) and along_path of a corner.
        .macro  see_corner x, z
        SUBNV   \x, [ox], [from_x]
        SUBNV   \z, [oz], [from_z]
        MPYSV   [path_dx], [from_z], [side]
        MPYSV   [path_dz], [from_x], [path_work]
        SUBNV   [side], [path_work], [side]
        MPYSV   [path_dx], [from_x], [along_path]
        MPYSV   [path_dz], [from_z], [path_work]
        ADDNV   [path_work], [along_path], [along_path]
        CMPGEV  [side], r0, [left]
        .endm

; Computes the crossings with the edges; found uses [crossed_at] in the lanes of
; [crossed].
        .macro  walk_edges found
        load_field P_TABLE, row_at
        RTOR    sh2, rows_left
prism_row\@:
        ELEN    row_at, 3
        SWAP    [row_at], here_x, [r0]          ; also here_z, begins
        IX      row_at, 64 * PRISM_SIZE
        see_corner here_x, here_z
        CFPNE   begins, r0, prism_next\@
        XORB    [left], [left_before], [crossed]
        CNTOB   [crossed], s0
        IBXEQ   s0, r0, r0, prism_next\@
        SUBNV   [side_before], [side], [path_work]
        MASKV   [path_work], one, [path_work] ? [crossed]
        DIVSV   [side_before], [path_work], [crossed_at]
        SUBNV   [along_path], [along_path_before], [path_work]
        MPYSV   [path_work], [crossed_at], [crossed_at]
        ADDNV   [along_path_before], [crossed_at], [crossed_at]
        MPYSV   [crossed_at], [inverse], [crossed_at]
        \found
prism_next\@:
        trade   side, side_before
        trade   along_path, along_path_before
        trade   left, left_before
        SUBN    rows_left, one, rows_left
        CFPLT   r0, rows_left, prism_row\@
        .endm

; Changes [inside] in the lanes in which an edge is crossed before [end].
        .macro  turn_before end, inside
        CMPLTV  [crossed_at], [\end], [bits0]
        ANDB    [bits0], [crossed], [bits0]
        XORB    [\inside], [bits0], [\inside]
        .endm

; Both macros restrict [bits] to the lanes with a < b, or with a >= b.  bits0
; changes.
        .macro  and_less a, b, bits
        CMPLTV  [\a], [\b], [bits0]
        ANDB    [bits0], [\bits], [\bits]
        .endm

        .macro  and_not_less a, b, bits
        CMPGEV  [\a], [\b], [bits0]
        ANDB    [bits0], [\bits], [\bits]
        .endm

; tin = the nearest sides ahead.
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

; tout = tin, or a miss.
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

; Inserts the crossings between the caps.  [inside_high] = their number is odd.
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
