; depth_1984.s - counts the bodies that contain each ray, ray by ray.
;
; Computes the same as depth_vector.s, in kernels mode.

        .share  loop
        .regs   r225, query_work, ray_hit_at, ray_hits_left
        .endshare

        .macro  plane_of field, into
        ES      \into, \field
        MPYX    \into, to_stride, \into
        .endm

        .macro  begin_ray_hits
        LOD     [to_counts, loop_index], ray_hits_left
        SHIFTI  loop_index, 6, ray_hit_at
        ADDX    ray_hit_at, to_first, ray_hit_at
        .endm

        .macro  next_ray_hit again
        ADDX    ray_hit_at, to_step, ray_hit_at
        IBXNE   ray_hits_left, m_index_minus_one, r0, \again, ray_hits_left
        .endm

        .kernel lines
count_depths:
        pass_operands query_stride, QUERY_OPERANDS, 0, query_operands
        to_scalar
        load_query_operands
        SHIFTI  to_stride, -6, to_stride        ; in words, like indices
        load_depth_planes
        RTOR    n, loop_count
        ES      loop_index, 0
depths_ray:
        begin_ray_hits
        IBXEQ   ray_hits_left, r0, r0, depths_none
        count_depths_of_ray
depths_none:
        loop_next depths_ray
        to_vector
        BIM     0, link_kernel
        .endkernel
