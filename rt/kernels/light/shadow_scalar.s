; shadow_scalar.s - how much of a light reaches a point.
;
;       CALL SHADOW (RAY, LIMIT, LIGHT)
;
; RAY = from the point towards the light, its least distance k_shadow (8 words,
; as in regions_scalar.s); LIMIT = the light's distance less k_shadow (1);
; LIGHT = its colour (3 words), what is left of it afterwards.
;
; An opaque surface between the two takes it away, and ends the work; a clear
; one multiplies it by the colour that it lets pass at the crossing, one after
; another towards the light, each of a region k_shadow or more beyond the one
; before (POV-Ray's rule).  Regions in the order of the scene, those that
; cast shadows.

        .equ    SHADOW_REGISTERS, WALK_REGISTERS + PASSING_REGISTERS

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
        IBXEQ   w_regions_left, r0, r0, shadow_done
        .endkernel
        .kernel bound
shadow_region:
        load_region
        IBXEQ   w_shadow, r0, r0, shadow_next
        skip_far w_cx, w_cy, w_cz, w_radius, w_square, w_limit, shadow_next
        .endkernel
        .kernel call
        IBXEQ   w_simple, r0, r0, shadow_tree
        meet_simple shadow_next
        .endkernel
        .kernel shadow
shadow_dark:
        RTOR    m_zero, s_red
        RTOR    m_zero, s_green
        RTOR    m_zero, s_blue
shadow_done:
        SWAP    [r0], s_red, [w_result_at]
        leave_walk shadow_save, SHADOW_REGISTERS
shadow_tree:
        EX      target, meet_tree
        BSAVE   w_back, [target]
        IBXEQ   w_met, r0, r0, shadow_next
        next_visible w_least, shadow_next
        IBXEQ   w_shadow, r0, m_index_one, shadow_dark
shadow_clear:
        pass_through shadow_dark
        ADDN    w_in, w_lower, w_in
        next_visible w_in, shadow_next
        BIM     shadow_clear
        .endkernel
        .kernel bound
shadow_next:
        next_region shadow_region
        BIM     shadow_done
        .endkernel
