; quadratic_prism.s - intersects rays with a prism of quadratic splines: closed
; loops of parabolas in x and z, swept along y from one cap to the other.
;
; The method is that of prism.s, but the edges are curved.  From a corner
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
; The roots are q/cross(bend) and side0/q (forms_vector.s).  If cross(lead)
; >= 0, side falls at the first and rises at the second, else the opposite.  An
; edge that is crossed once has the root at which side changes as its corners
; do, clamped to 0 .. 1.
;
; The routines are those of prism.s: QUADRATIC_PRISM, OPEN_QUADRATIC_PRISM,
; QUADRATIC_PRISM_SOLID, OPEN_QUADRATIC_PRISM_SIDES.
; In, out: as for prism, prism_solid and so on; the rows are those of records.s.
; Record: that of prism.s.
; Source: textbook; derived here.

        .if     QUADRATIC_PRISMS
        .reg    side_bend, e0
        .reg    side_lead, e1
        .reg    side_q, e2
        .reg    along_bend, e3
        .reg    along_lead, e4                  ; 2 dot(lead)
        .reg    curve_at, e5                    ; w
        .reg    end_x, row5
        .reg    end_z, row6
        .reg    loop_begins, row7
        .reg    bend_x, row8
        .reg    bend_z, row9
        .reg    lead_x, row10
        .reg    lead_z, row11

; Computes w of an edge that is crossed once.
        .macro  curve_once
        turned_by side_lead, left, chosen       ; those of q / cross(bend)
        either_two chosen, side_q, side_before, curve_at, side_bend, side_q, t1
        ray_if_equal_number t1, r0, once_divided\@
        ray_then_set one, t1
        ray_end_if once_divided\@
        ray_quotient curve_at, t1, curve_at
        ray_not_below_number r0, curve_at
        ray_not_above_number one, curve_at
        .endm

        .macro  cross_curve
        ray_times along_bend, curve_at, t1
        ray_plus t1, along_lead, t1
        ray_times t1, curve_at, t1
        ray_plus t1, along_path_before, t1
        ray_times t1, inverse, crossed_at
        .endm

; Computes the crossings with the edges; found uses crossed_at of the rays of
; crossed.  bits1: those that cross an edge twice.
        .macro  walk_curves found
        load_field P_TABLE, row_at
        RTOR    sh2, rows_left
curve\@:
        load_from row_at, 7, end_x              ; end_x .. lead_z
        IX      row_at, 64 * QUADRATIC_SIZE
        see_corner end_x, end_z, mark_side
        CFPNE   loop_begins, r0, curve_passed\@
        exclusive left, left_before, crossed
        ray_scaled_minus_scaled_two path_dx, bend_z, path_dz, bend_x, side_bend, path_dx, lead_z, path_dz, lead_x, side_lead
        find_turning side_bend, side_lead, left, crossed, bits1, curve_passed\@
        ray_times side_lead, side_lead, t0
        ray_times side_bend, side_before, t1
        ray_minus t0, t1, t0
        keep_positive t0, bits1, crossed, curve_passed\@
        ray_scaled_plus_scaled_two path_dx, bend_x, path_dz, bend_z, along_bend, path_dx, lead_x, path_dz, lead_z, along_lead
        ray_plus along_lead, along_lead, along_lead
        ray_not_below_number r0, t0
        ray_root t0, t0
        sum_away side_lead, t0, side_q, chosen
        if_any  crossed, curve_both\@
        curve_once
        cross_curve
        \found
        done    curve_passed\@
curve_both\@:
        skip_empty bits1, curve_passed\@
        quotient_in bits1, side_q, side_bend, curve_at
        cross_curve
        copy_set bits1, crossed
        \found
        quotient_in bits1, side_before, side_q, curve_at
        cross_curve
        copy_set bits1, crossed
        \found
curve_passed\@:
        keep_before side, side_before
        keep_before along_path, along_path_before
        keep_before left, left_before
        SUBN    rows_left, one, rows_left
        CFPLT   r0, rows_left, curve\@
        .endm

        saves   quadratic, 80, r76
        .kernel quadratic_prism
        prism_routines quadratic_prism, quadratic, walk_curves
        .endkernel
        .endif
