; depth_scalar.s - counts the bodies that contain a ray after each crossing.
;
; See depth_vector.s. These macros are parts of the main program.

        .equ    DEPTH_SIZE, 1           ; words of an object
        .regs   r232, depth_crossing, depth_at, depth_object, depth_scene

; Sets depth_at to the address of the body count for the object of the primitive
; whose number is in depth_at.
        .macro  find_count
        ES      query_work, P_SIZE
        ADDX    depth_at, m_index_minus_one, depth_at
        MPYX    depth_at, query_work, depth_at
        SHIFTI  depth_at, 6, depth_at
        load_word scene_primitives, query_work
        ADDX    depth_at, query_work, depth_at
        IX      depth_at, 64 * P_OBJECT
        LOD     [depth_at], depth_at
        SHIFTI  depth_at, 6, depth_at
        load_word query_depths, query_work
        ADDX    depth_at, query_work, depth_at
        .endm

; Sets depth_at to the address of the count for the object crossed at ray_hit_at.
        .macro  find_object
        LOD     [ray_hit_at, m_index_one], depth_at
        find_count
        .endm

; Processes the crossings of the ray from ray_hit_at on. Their number
; ray_hits_left is at least 1.
        .macro  count_depths_of_ray
        ES      depth_scene, 0
depths_next\@:
        find_object
        RTOR    ray_hit_at, query_work
        IX      query_work, 64 * RAY_HIT_CROSSING
        LOD     [query_work], depth_crossing
        LOD     [depth_at], depth_object
        ADDX    depth_object, depth_crossing, depth_object
        ADDX    depth_scene, depth_crossing, depth_scene
        STO     [depth_at], depth_object
        IX      query_work, 64 * (RAY_HIT_OBJECT_DEPTH - RAY_HIT_CROSSING)
        STO     [query_work], depth_object
        STO     [query_work, m_index_one], depth_scene
        IX      ray_hit_at, 64 * RAY_HIT_SIZE
        IBXNE   ray_hits_left, m_index_minus_one, r0, depths_next\@, ray_hits_left
        load_ray_hits
depths_clear\@:
        find_object
        STO     [depth_at], r0
        IX      ray_hit_at, 64 * RAY_HIT_SIZE
        IBXNE   ray_hits_left, m_index_minus_one, r0, depths_clear\@, ray_hits_left
        load_ray_hits
        .endm
