; prism_scalar.s - intersects one ray with a prism: loops of edges, swept along
; y.
;
;       CALL PRISM (RAY, PRIMITIVE, SEGMENT)
;       CALL OPEN_PRISM (RAY, PRIMITIVE, SEGMENT)
;       CALL PRISM_SOLID (RAY, PRIMITIVE, SEGMENTS)
;       CALL OPEN_PRISM_SIDES (RAY, PRIMITIVE, CROSSINGS)
;
; The arguments are those of sphere_scalar.s, the method is that of
; prism_vector.s.  SEGMENTS receives P_SEGMENTS segments of the ray inside.
; CROSSINGS receives the crossings with the sides between the caps, in twice as
; many words: ascending, the last one repeated if their number is odd, then
; misses.

        .ifndef LANE_REGISTERS
        .include "shapes/lanes_scalar.s"
        .endif
        .ifndef LIST_REGISTERS
        .include "shapes/columns_scalar.s"
        .endif

        .share  local
        .regs   r79, row_at, rows_left, here_x, here_z, begins
        .regs   r84, path_dx, path_dz, inverse, side, side_before, along_path, along_path_before
        .regs   r91, edge_low, edge_high, cap_low, cap_high
        .regs   r97, inside_low, inside_high
        .endshare
        .equ    PRISM_REGISTERS, 70

        .data
prism_save:     .space PRISM_REGISTERS
        .code

; Computes the part of the ray between the planes of the caps, or branches to
; miss, and the ray's path perpendicular to y.
        .macro  enter_prism miss, save=prism_save, registers=PRISM_REGISTERS
        enter_solver 3, \save, \registers
        RTOR    lower, least
        RTOR    minus_big, tin
        RTOR    big, tout
        slab    oy, dy, sh0, sh1, \miss
        RTOR    tin, cap_low
        RTOR    tout, cap_high
        RTOR    tin, edge_low
        RTOR    tout, edge_high
        ES      inside_low, 0
        ES      inside_high, 0
        MPYS    dx, dx, t0
        MPYS    dz, dz, t1
        MPYS    tiny, tiny, t2
        RTOR    dx, path_dx
        RTOR    dz, path_dz
        ADDN    t1, t0, t0
        CFPGE   t0, t2, prism_slanted\@
        RTOR    one, t0
        RTOR    one, path_dx
        RTOR    r0, path_dz
        RTOR    r0, edge_low
        RTOR    r0, edge_high
prism_slanted\@:
        DIVS    one, t0, inverse
        .endm

; Computes the crossings with the edges; found uses each crossed_at.
        .macro  walk_edges found
        RTOR    a_primitive, t0
        IX      t0, 64 * P_TABLE
        LOD     [t0], row_at
        RTOR    sh2, rows_left
prism_row\@:
        ELEN    row_at, 3
        SWAP    [row_at], here_x, [r0]          ; also here_z, begins
        IX      row_at, 64 * PRISM_SIZE
        SUBN    here_x, ox, t0
        SUBN    here_z, oz, t1
        MPYS    path_dx, t1, t2
        MPYS    path_dz, t0, t3
        MPYS    path_dx, t0, t4
        MPYS    path_dz, t1, t5
        SUBN    t2, t3, side
        ADDN    t5, t4, along_path
        CFPNE   begins, r0, prism_next\@
        CFPGE   side, r0, prism_left\@
        CFPLT   side_before, r0, prism_next\@
        BIM     prism_crossed\@
prism_left\@:
        CFPGE   side_before, r0, prism_next\@
prism_crossed\@:
        SUBN    side_before, side, t0
        DIVS    side_before, t0, t0
        SUBN    along_path, along_path_before, t1
        MPYS    t1, t0, t0
        ADDN    along_path_before, t0, t0
        MPYS    t0, inverse, crossed_at
        \found
prism_next\@:
        RTOR    side, side_before
        RTOR    along_path, along_path_before
        SUBN    rows_left, one, rows_left
        CFPLT   r0, rows_left, prism_row\@
        .endm

; tin = the nearest side ahead.
        .macro  side_ahead
        CFPLT   crossed_at, edge_low, side_not\@
        CFPLT   edge_high, crossed_at, side_not\@
        CFPGE   least, crossed_at, side_not\@
        CFPGE   crossed_at, tin, side_not\@
        RTOR    crossed_at, tin
side_not\@:
        .endm

        .macro  side_or_cap_ahead
        CFPGE   crossed_at, edge_low, cap_low_not\@
        XOR     inside_low, index_one, inside_low
cap_low_not\@:
        CFPGE   crossed_at, edge_high, cap_high_not\@
        XOR     inside_high, index_one, inside_high
cap_high_not\@:
        side_ahead
        .endm

        .macro  cap_ahead inside, cap
        IBXEQ   \inside, r0, r0, cap_not\@
        CFPGE   least, \cap, cap_not\@
        CFPGE   \cap, tin, cap_not\@
        RTOR    \cap, tin
cap_not\@:
        .endm

        .macro  leave_prism miss, save=prism_save, registers=PRISM_REGISTERS
        CFPGE   tin, big, \miss
        RTOR    tin, tout
        leave_solver \save, \registers
        .endm

        .kernel prism
prism:
        enter_prism prism_miss
        RTOR    big, tin
        walk_edges side_or_cap_ahead
        cap_ahead inside_low, cap_low
        cap_ahead inside_high, cap_high
        leave_prism prism_miss
open_prism:
        enter_prism prism_miss
        RTOR    big, tin
        walk_edges side_ahead
        leave_prism prism_miss
prism_miss:
        miss_near prism_save, PRISM_REGISTERS

; Inserts the crossings between the caps.  inside_high = 1: their number is odd.
        .macro  between_caps
        CFPLT   edge_low, crossed_at, between_above\@
        XOR     inside_low, index_one, inside_low
        BIM     between_not\@
between_above\@:
        CFPGE   crossed_at, edge_high, between_not\@
        XOR     inside_high, index_one, inside_high
        insert
between_not\@:
        .endm

        .macro  side_between
        CFPLT   crossed_at, edge_low, between_not\@
        CFPLT   edge_high, crossed_at, between_not\@
        insert
between_not\@:
        .endm

prism_solid:
        enter_prism prism_passed
        begin_list
        walk_edges between_caps
        XOR     inside_high, inside_low, inside_high
        IBXEQ   inside_low, r0, r0, prism_above
        RTOR    cap_low, crossed_at
        insert
prism_above:
        IBXEQ   inside_high, r0, r0, prism_fill
        RTOR    cap_high, crossed_at
        insert
        BIM     prism_fill
open_prism_sides:
        enter_prism prism_passed
        begin_list
        walk_edges side_between
        BIM     prism_fill
prism_passed:
        begin_list
prism_fill:
        leave_list prism_save, PRISM_REGISTERS
        .endkernel
