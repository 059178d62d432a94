; lanes_scalar.s - prepares one ray for the root solver and computes tin and
; tout from its roots.  The method is that of lanes_vector.s; the first test
; that shows a miss ends the computation.

        .ifndef LANE_REGISTERS
        .include "roots/quartic_scalar.s"

        .share  local
        .reg    lower, tin                      ; overwritten by tin
        .regs   r58, k4, k3, k2, k1, k0         ; coefficients
        .regs   r63, near_low, near_high, near_resolution
        .regs   r66, along, near_o2, link_kept
        .regs   r69, e0, e1, e2, e3, e4, e5, e6
        .endshare
        .regs   t0, near_ox, near_oy, near_oz
        .regs   dx, near_dx, near_dy, near_dz
        shape_from r76
        .equ    LANE_REGISTERS, 54              ; up to sh9, the last of a torus

        .data
near_save:      .space LANE_REGISTERS
near_input:     .space 8
near_roots:     .space 5
near_list:      .descriptor 5, near_input
                .descriptor 3, near_input + 64 * 5
                .descriptor 5, near_roots
        .code

        .macro  enter_solver words, save=near_save, registers=LANE_REGISTERS
        enter   kernel_image, KERNEL_CONSTANTS, \save, \registers
        load_from arguments, 3, a_ray
        load_from a_ray, 7, ox
        load_part a_primitive, P_SHAPE, \words, sh0, t0
        RTOR    link, link_kept
        .endm

        .macro  leave_solver save=near_save, registers=LANE_REGISTERS
        RTOR    link_kept, link
        give_segment
        leave   \save, \registers
        .endm

; The first steps of find_lanes and find_all_lanes.
        .macro  find_bound x0, x1, x2, bound2, miss
        closest_approach \x0, \x1, \x2, t0, t1, t2, along, t3, t4
        dot     t0, t1, t2, t0, t1, t2, near_o2, t4
        SUBN    \bound2, near_o2, near_high
        CFPGE   r0, near_high, \miss
        SQRT    near_high, near_high
        .endm

; Computes o (t0-t2), o . o (near_o2), near_low and near_high, or branches to
; miss.
        .macro  find_lanes x0, x1, x2, bound2, miss
        find_bound \x0, \x1, \x2, \bound2, \miss
        ADDN    lower, along, near_low
        SUBN    r0, near_high, t3
        CFPLT   t3, near_low, find_lanes_ahead\@
        RTOR    t3, near_low
find_lanes_ahead\@:
        CFPGE   near_low, near_high, \miss
        .endm

; Passes the quartic and its interval to a routine of the solver.
        .macro  call_quartic routine
        store_words k4, 8, near_input, t3
        call    \routine, near_list
        .endm

; Sets tin = tout = the first root, or branches to miss.
        .macro  solve_near resolution, miss
        RTOR    \resolution, near_resolution
        call_quartic solve_quartic
        EX      t3, near_roots
        LOD     [t3], tin
        CFPGE   tin, big, \miss
        SUBN    tin, along, tin
        RTOR    tin, tout
        .endm

; Returns a miss.
        .macro  miss_near save=near_save, registers=LANE_REGISTERS
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_solver \save, \registers
        .endm

        .include "solids/segments_scalar.s"

; ---- Tori --------------------------------------------------------------------

        .macro  enter_lanes words
        enter_solver \words
        .endm

        no_code take_lanes

        .macro  leave_at_root resolution, miss
        solve_near \resolution, \miss
        leave_solver
        .endm

        .macro  leave_with_segments resolution, passed
        solve_all \resolution
        BIM     segments\@
\passed:
        ADDN    r0, r0, e0
segments\@:
        ES      e4, 0
        give_segments 4
        leave_segments
        .endm
        .endif
