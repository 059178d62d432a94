; depth_1984.s - counts the bodies that contain each ray, ray by ray.
;
; Computes the same as depth_vector.s, in kernels mode.

        .share  loop
        .regs   r225, query_work, ray_hit_at, ray_hits_left
        .regs   r228, to_primitive, to_crossing, to_object_depth, to_scene_depth
        .endshare

        .macro  plane_of field, into
        ES      \into, \field
        MPYX    \into, to_stride, \into
        .endm

; Sets depth_at to the address of the count for the object crossed at ray_hit_at.
        .macro  find_object_at
        LOD     [ray_hit_at, to_primitive], depth_at
        find_count
        .endm

; Finds the first crossing of the ray. Branches to `none` if it has no
; crossing.
        .macro  begin_ray_hits none
        LOD     [to_counts, loop_index], ray_hits_left
        IBXEQ   ray_hits_left, r0, r0, \none
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
        load_at query_operands, QUERY_OPERANDS, to_stride
        SHIFTI  to_stride, -6, to_stride        ; in words, like indices
        plane_of RAY_HIT_PRIMITIVE, to_primitive
        plane_of RAY_HIT_CROSSING, to_crossing
        plane_of RAY_HIT_OBJECT_DEPTH, to_object_depth
        plane_of RAY_HIT_SCENE_DEPTH, to_scene_depth
        RTOR    n, loop_count
        ES      loop_index, 0
depths_ray:
        begin_ray_hits depths_none
        ES      depth_scene, 0
depths_next:
        find_object_at
        LOD     [ray_hit_at, to_crossing], depth_crossing
        LOD     [depth_at], depth_object
        ADDX    depth_object, depth_crossing, depth_object
        ADDX    depth_scene, depth_crossing, depth_scene
        STO     [depth_at], depth_object
        STO     [ray_hit_at, to_object_depth], depth_object
        STO     [ray_hit_at, to_scene_depth], depth_scene
        next_ray_hit depths_next
        begin_ray_hits depths_none
depths_clear:
        find_object_at
        STO     [depth_at], r0
        next_ray_hit depths_clear
depths_none:
        loop_next depths_ray
        to_vector
        BIM     0, link_kernel
        .endkernel
