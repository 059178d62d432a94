; fog_1984.s - applies fogs to the colours of n rays, one ray after another.
;
; In, out: as for fog_rays of routines_vector.s.

        .share  loop
        .regs   r156, fog_depths_at, fog_reds_at, fog_greens_at, fog_blues_at
        .regs   r160, ray_red, ray_green, ray_blue
        .endshare

        .kernel resolve
fog_rays:
        pass_operands fog_depth
        pass_operands out_red, 3, 1
        pass_operands n, 1, 4
        to_scalar
        load_words operands, 4, fog_depths_at
        load_words operands + 64 * 4, 1, loop_count
        ES      loop_index, 0
fog_ray:
        LOD     [fog_depths_at, loop_index], fog_distance
        load_three fog_reds_at, fog_greens_at, fog_blues_at, loop_index, ray_red, ray_green, ray_blue
        see_through_fog ray_red, ray_green, ray_blue
        store_three fog_reds_at, fog_greens_at, fog_blues_at, loop_index, ray_red, ray_green, ray_blue
        loop_next fog_ray
        to_vector
        BIM     0, link_kernel
        .endkernel
