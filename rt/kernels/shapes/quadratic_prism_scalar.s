; quadratic_prism_scalar.s - intersects one ray with a prism of quadratic
; splines: loops of parabolas, swept along y.
;
;       CALL QUADRATIC_PRISM (RAY, PRIMITIVE, SEGMENT)
;       CALL OPEN_QUADRATIC_PRISM (RAY, PRIMITIVE, SEGMENT)
;       CALL QUADRATIC_PRISM_SOLID (RAY, PRIMITIVE, SEGMENTS)
;       CALL OPEN_QUADRATIC_PRISM_SIDES (RAY, PRIMITIVE, CROSSINGS)
;
; The arguments are those of prism_scalar.s, the method is that of
; quadratic_prism_vector.s.

        .if     QUADRATIC_PRISMS
        .share  local
        .regs   r102, bend_x, bend_z, lead_x, lead_z
        .regs   r106, side_bend, side_lead, side_q, along_bend, along_lead, curve_at
        .regs   r112, left, left_before
        .endshare
        .equ    QUADRATIC_REGISTERS, 82

        .data
quadratic_save: .space QUADRATIC_REGISTERS
        .code

; Loads bend and lead of the row at row_at.  Computes cross(bend) and
; cross(lead).
        .macro  load_curve
        RTOR    row_at, t2
        IX      t2, 64 * QUADRATIC_BEND
        ELEN    t2, 4
        SWAP    [t2], bend_x, [r0]              ; bend_x .. lead_z
        MPYS    path_dx, bend_z, side_bend
        MPYS    path_dz, bend_x, t2
        MPYS    path_dx, lead_z, side_lead
        MPYS    path_dz, lead_x, t3
        SUBN    side_bend, t2, side_bend
        SUBN    side_lead, t3, side_lead
        .endm

; Branches to passed if side does not return to the value of the corners.
        .macro  find_both_roots passed
        CFPLT   side_lead, r0, both_falls\@
        IBXNE   left, r0, r0, \passed
        ADDN    side_lead, side_bend, t0
        CFPGE   t0, r0, \passed
        BIM     both_end\@
both_falls\@:
        IBXEQ   left, r0, r0, \passed
        ADDN    side_lead, side_bend, t0
        CFPLT   t0, r0, \passed
both_end\@:
        .endm

; t0 = the square of the root.
        .macro  square_of_root
        MPYS    side_lead, side_lead, t0
        MPYS    side_bend, side_before, t1
        SUBN    t0, t1, t0
        .endm

; Computes q, dot(bend) and 2 dot(lead).
        .macro  solve_curve
        MPYS    path_dx, bend_x, along_bend
        MPYS    path_dz, bend_z, t2
        MPYS    path_dx, lead_x, along_lead
        MPYS    path_dz, lead_z, t3
        SQRT    t0, t0
        ABS     side_lead, t1
        ADDN    t2, along_bend, along_bend
        ADDN    t3, along_lead, along_lead
        ADDN    t1, t0, side_q
        ADDN    along_lead, along_lead, along_lead
        CFPLT   side_lead, r0, curve_solved\@
        SUBN    r0, side_q, side_q
curve_solved\@:
        .endm

; Computes w of an edge that is crossed once: q / cross(bend) if t0 = 1, else
; side0 / q.
        .macro  curve_once
        RTOR    left, t0
        CFPLT   side_lead, r0, once_sign\@
        XOR     t0, index_one, t0
once_sign\@:
        RTOR    side_before, t1
        RTOR    side_q, t2
        IBXEQ   t0, r0, r0, once_chosen\@
        RTOR    side_q, t1
        RTOR    side_bend, t2
once_chosen\@:
        CFPNE   t2, r0, once_divided\@
        RTOR    one, t2
once_divided\@:
        DIVS    t1, t2, curve_at
        CFPGE   curve_at, r0, once_above\@
        ADDN    r0, r0, curve_at
once_above\@:
        CFPGE   one, curve_at, once_below\@
        RTOR    one, curve_at
once_below\@:
        .endm

        .macro  cross_curve
        MPYS    along_bend, curve_at, t1
        ADDN    t1, along_lead, t1
        MPYS    t1, curve_at, t1
        ADDN    t1, along_path_before, t1
        MPYS    t1, inverse, crossed_at
        .endm

; Computes the crossings with the edges; found uses each crossed_at.
        .macro  walk_curves found
        RTOR    a_primitive, t0
        IX      t0, 64 * P_TABLE
        LOD     [t0], row_at
        RTOR    sh2, rows_left
curve\@:
        ELEN    row_at, 3
        SWAP    [row_at], here_x, [r0]          ; also here_z, begins
        SUBN    here_x, ox, t0
        SUBN    here_z, oz, t1
        MPYS    path_dx, t1, t2
        MPYS    path_dz, t0, t3
        MPYS    path_dx, t0, t4
        MPYS    path_dz, t1, t5
        ES      left, 0
        SUBN    t2, t3, side
        ADDN    t5, t4, along_path
        CFPLT   side, r0, curve_sided\@
        ES      left, 1
curve_sided\@:
        CFPNE   begins, r0, curve_passed\@
        load_curve
        IBXNE   left, r0, left_before, curve_once\@
        find_both_roots curve_passed\@
        square_of_root
        CFPGE   r0, t0, curve_passed\@
        solve_curve
        DIVS    side_q, side_bend, curve_at
        cross_curve
        \found
        DIVS    side_before, side_q, curve_at
        cross_curve
        \found
        BIM     curve_passed\@
curve_once\@:
        square_of_root
        CFPGE   t0, r0, curve_real\@
        ADDN    r0, r0, t0
curve_real\@:
        solve_curve
        curve_once
        cross_curve
        \found
curve_passed\@:
        IX      row_at, 64 * QUADRATIC_SIZE
        RTOR    side, side_before
        RTOR    along_path, along_path_before
        RTOR    left, left_before
        SUBN    rows_left, one, rows_left
        CFPLT   r0, rows_left, curve\@
        .endm

        .kernel quadratic_prism
quadratic_prism:
        enter_prism quadratic_miss, quadratic_save, QUADRATIC_REGISTERS
        RTOR    big, tin
        walk_curves side_or_cap_ahead
        cap_ahead inside_low, cap_low
        cap_ahead inside_high, cap_high
        leave_prism quadratic_miss, quadratic_save, QUADRATIC_REGISTERS
open_quadratic_prism:
        enter_prism quadratic_miss, quadratic_save, QUADRATIC_REGISTERS
        RTOR    big, tin
        walk_curves side_ahead
        leave_prism quadratic_miss, quadratic_save, QUADRATIC_REGISTERS
quadratic_miss:
        miss_near quadratic_save, QUADRATIC_REGISTERS

quadratic_prism_solid:
        enter_prism quadratic_passed, quadratic_save, QUADRATIC_REGISTERS
        begin_list
        walk_curves between_caps
        XOR     inside_high, inside_low, inside_high
        IBXEQ   inside_low, r0, r0, quadratic_above
        RTOR    cap_low, crossed_at
        insert
quadratic_above:
        IBXEQ   inside_high, r0, r0, quadratic_fill
        RTOR    cap_high, crossed_at
        insert
        BIM     quadratic_fill
open_quadratic_prism_sides:
        enter_prism quadratic_passed, quadratic_save, QUADRATIC_REGISTERS
        begin_list
        walk_curves side_between
        BIM     quadratic_fill
quadratic_passed:
        begin_list
quadratic_fill:
        leave_list quadratic_save, QUADRATIC_REGISTERS
        .endkernel
        .endif
