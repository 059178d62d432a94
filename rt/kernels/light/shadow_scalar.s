; shadow_scalar.s - computes the share of a light that reaches a point.
;
;       CALL SHADOW (RAY, LIMIT, LIGHT)
;
; RAY = from the point towards the light, its lower limit k_shadow (8 words, as
; in regions_scalar.s); LIMIT = the light's distance minus k_shadow (1 word),
; followed by the address of the light's position, or 0, for meshes; LIGHT = its
; colour (3 words), at the end the colour that reaches the point.
;
; An opaque surface between the two blocks the light and ends the computation.
; A transparent one multiplies it by the colour that it transmits at the
; crossing.  The crossings are processed in order towards the light; within a
; region each is k_shadow or more beyond the previous one (POV-Ray's rule).
; Regions with transparent parts are processed after the others, from a list in
; the order of the scene: so the product does not depend on the order of
; traversal.

        .share  local
        .regs   r96, s_waiting, s_waiting_end
        .endshare
        .equ    SHADOW_REGISTERS, WALK_REGISTERS + TRANSMITTED_REGISTERS + 2

        .data
shadow_save:    .space SHADOW_REGISTERS
        .code

        .kernel shadow
shadow:
        enter_walk shadow_save, SHADOW_REGISTERS, 3
        EX      w_at, rays_shadow
        LOD     [w_at], w_t0
        LOD     [w_argument], w_limit
        SWAP    [w_result_at], s_red, [r0]
        IS      w_t0, 1
        STO     [w_at], w_t0
        load_word scene_clear, s_waiting
        RTOR    s_waiting, s_waiting_end
        IBXEQ   w_regions_left, r0, r0, shadow_leaf
        .endkernel
        .kernel bound
shadow_region:
        load_region
        IBXEQ   w_shadow, r0, r0, shadow_next
        skip_far w_cx, w_cy, w_cz, w_radius, w_square, w_limit, shadow_next
        .endkernel
        .kernel call
        IBXNE   w_flags, r0, m_index_one, shadow_other
shadow_simple:
        intersect_simple shadow_dark, shadow_next
        BIM     shadow_next
        .endkernel
        .kernel shadow
shadow_dark:
        RTOR    m_zero, s_red
        RTOR    m_zero, s_green
        RTOR    m_zero, s_blue
shadow_done:
        SWAP    [r0], s_red, [w_result_at]
        leave_walk shadow_save, SHADOW_REGISTERS
        .endkernel
        .kernel bound
shadow_other:
        test_box shadow_tree, shadow_simple, shadow_next
        .endkernel
        .kernel shadow
shadow_tree:
        IBXNE   w_shadow, r0, m_index_one, shadow_wait
        RTOR    w_limit, w_end
        call_routine intersect_tree, w_back
        IBXEQ   w_hit, r0, r0, shadow_next
        next_visible w_least, shadow_next
        BIM     shadow_dark

; Inserts the region into the list.
shadow_wait:
        load_of w_region, R_CLEAR, w_t0
        RTOR    s_waiting_end, w_at
        IX      s_waiting_end, 64
shadow_wait_before:
        IBXEQ   w_at, r0, s_waiting, shadow_wait_here
        LOD     [w_at, m_index_minus_one], w_t1
        load_of w_t1, R_CLEAR, w_t2
        IBXLT   w_t2, r0, w_t0, shadow_wait_here
        STO     [w_at], w_t1
        IX      w_at, -64
        BIM     shadow_wait_before
shadow_wait_here:
        STO     [w_at], w_region
        .endkernel

        .kernel bound
shadow_next:
        next_region shadow_region
shadow_leaf:
        next_leaf shadow_region, shadow_waiting
        .endkernel

        .kernel shadow
shadow_waiting:
        IBXEQ   s_waiting, r0, s_waiting_end, shadow_done
        LOD     [s_waiting], w_region
        IX      s_waiting, 64
        load_region
        RTOR    w_limit, w_end
        call_routine intersect_tree, w_back
        IBXEQ   w_hit, r0, r0, shadow_waiting
        next_visible w_least, shadow_waiting
shadow_clear:
        pass_through shadow_dark
        ADDN    w_in, w_lower, w_in
        next_visible w_in, shadow_waiting
        BIM     shadow_clear
        .endkernel
