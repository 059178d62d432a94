; quadratic_prism_vector.s - intersects a queue of rays with a prism of
; quadratic splines: closed loops of parabolas in x and z, swept along y from
; one cap to the other.
;
; The method is that of prism_vector.s, but the edges are curved.  From a corner
; P to the next one the points are  P + (bend w + 2 lead) w,  w from 0 to 1.
; With cross = dx z - dz x  and  dot = dx x + dz z  of a vector x, z, an edge
; has
;
;   side(w) = (cross(bend) w + 2 cross(lead)) w + side0
;   along_path(w) = (dot(bend) w + 2 dot(lead)) w + along_path(0)
;
; An edge is crossed once if side is >= 0 at exactly one of its corners.
; Otherwise it is crossed twice or never: twice if the slope of side,
; cross(lead) at w = 0 and cross(lead) + cross(bend) at w = 1, changes its sign,
; if side first approaches 0, and if it has roots.  So a line crosses each loop
; an even number of times, independently of rounding.
;
; The roots are q/cross(bend) and side0/q (quadratic_vector.s).  If cross(lead)
; >= 0, side falls at the first and rises at the second, else the opposite.  An
; edge that is crossed once has the root at which side changes as its corners
; do, clamped to 0 .. 1.
;
; In, out: as for prism, prism_solid and so on; the rows are those of records.s.
; Source: textbook; derived here.

        .if     QUADRATIC_PRISMS
        .reg    side_bend, e0
        .reg    side_lead, e1
        .reg    side_q, e2
        .reg    along_bend, e3
        .reg    along_lead, e4          ; 2 dot(lead)
        .reg    curve_at, e5            ; w
        .reg    both, bits1             ; the lanes that cross twice

; The words of a row.
        .share  shape
        .regs   r43, end_x, end_z, loop_begins, bend_x, bend_z, lead_x, lead_z
        .endshare

        .macro  cross_row x, z, into
        MPYSV   [path_dx], \z, [\into]
        LINKV
        MPYSV   [path_dz], \x, [w0]
        SUBNV   [\into], [w0], [\into]
        .endm

        .macro  dot_row x, z, into
        MPYSV   [path_dx], \x, [\into]
        LINKV
        MPYSV   [path_dz], \z, [w1]
        ADDNV   [w1], [\into], [\into]
        .endm

; [both] = the lanes in which the slope of side changes its sign and side first
; approaches 0.
        .macro  find_both_roots
        ADDNV   [side_lead], [side_bend], [w1]
        CMPLTV  [side_lead], r0, [bits0]
        CMPLTV  [w1], r0, [both]
        XORB    [bits0], [both], [both]
        XORB    [left], [bits0], [bits0]
        ORB     [bits0], [crossed], [bits0]
        ANDNB   [both], [bits0], [both]
        .endm

        .macro  pass_unless_crossed passed
        ORB     [both], [crossed], [bits0]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, \passed
        .endm

; Computes q from the square of the root in [w0].  [bits0] = cross(lead) >= 0.
        .macro  solve_curve
        CMPLTV  [w0], r0, [bits0]
        VTOV    r0, [w0] ? [bits0]
        SQRTV   [w0], [w0]
        ADDNV   |[side_lead]|, [w0], [side_q]
        CMPGEV  [side_lead], r0, [bits0]
        VTOV    -[side_q], [side_q] ? [bits0]
        .endm

; Computes w of the lanes that cross once.
        .macro  curve_once
        XORB    [bits0], [left], [bits0]        ; those of q / cross(bend)
        MASKV   [side_q], [side_before], [curve_at] ? [bits0]
        MASKV   [side_bend], [side_q], [w1] ? [bits0]
        CMPEQV  [w1], r0, [bits0]
        VTOV    one, [w1] ? [bits0]
        DIVSV   [curve_at], [w1], [curve_at]
        CMPLTV  [curve_at], r0, [bits0]
        VTOV    r0, [curve_at] ? [bits0]
        CMPLTV  one, [curve_at], [bits0]
        VTOV    one, [curve_at] ? [bits0]
        .endm

; Computes w of the lanes of [both] as over / under.
        .macro  curve_twice over, under
        MASKV   [\under], one, [w1] ? [both]
        DIVSV   [\over], [w1], [curve_at]
        .endm

        .macro  cross_curve
        MPYSV   [along_bend], [curve_at], [w1]
        ADDNV   [w1], [along_lead], [w1]
        MPYSV   [w1], [curve_at], [w1]
        ADDNV   [w1], [along_path_before], [w1]
        MPYSV   [w1], [inverse], [crossed_at]
        .endm

; Computes the crossings with the edges; found uses [crossed_at] in the lanes of
; [crossed].
        .macro  walk_curves found
        load_field P_TABLE, row_at
        RTOR    sh2, rows_left
curve\@:
        ELEN    row_at, 7
        SWAP    [row_at], end_x, [r0]           ; end_x .. lead_z
        IX      row_at, 64 * QUADRATIC_SIZE
        see_corner end_x, end_z
        CFPNE   loop_begins, r0, curve_passed\@
        XORB    [left], [left_before], [crossed]
        cross_row bend_x, bend_z, side_bend
        cross_row lead_x, lead_z, side_lead
        find_both_roots
        pass_unless_crossed curve_passed\@
        MPYSV   [side_lead], [side_lead], [w0]
        MPYSV   [side_bend], [side_before], [w1]
        SUBNV   [w0], [w1], [w0]
        CMPLTV  r0, [w0], [bits0]
        ANDB    [bits0], [both], [both]
        pass_unless_crossed curve_passed\@
        dot_row bend_x, bend_z, along_bend
        dot_row lead_x, lead_z, along_lead
        ADDNV   [along_lead], [along_lead], [along_lead]
        solve_curve
        CNTOB   [crossed], s0
        IBXEQ   s0, r0, r0, curve_both\@
        curve_once
        cross_curve
        \found
curve_both\@:
        CNTOB   [both], s0
        IBXEQ   s0, r0, r0, curve_passed\@
        curve_twice side_q, side_bend
        cross_curve
        ANDB    [both], [both], [crossed]
        \found
        curve_twice side_before, side_q
        cross_curve
        ANDB    [both], [both], [crossed]
        \found
curve_passed\@:
        trade   side, side_before
        trade   along_path, along_path_before
        trade   left, left_before
        SUBN    rows_left, one, rows_left
        CFPLT   r0, rows_left, curve\@
        .endm

        .kernel quadratic_prism
quadratic_prism:
        begin_prism
        VTOV    big, [tin]
        walk_curves side_or_cap_ahead
        cap_ahead inside_low, cap_low
        cap_ahead inside_high, cap_high
        leave_prism

open_quadratic_prism:
        begin_prism
        VTOV    big, [tin]
        walk_curves side_ahead
        leave_prism

quadratic_prism_solid:
        begin_prism
        clear_columns
        walk_curves between_caps
        XORB    [inside_high], [inside_low], [inside_high]
        insert_cap inside_low, cap_low
        insert_cap inside_high, cap_high
        BIM     quadratic_prism_fill

open_quadratic_prism_sides:
        begin_prism
        clear_columns
        walk_curves side_between
quadratic_prism_fill:
        leave_columns
        .endkernel
        .endif
