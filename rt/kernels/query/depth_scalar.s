; depth_scalar.s - counts the bodies that contain a ray after each crossing.
;
; See depth_vector.s. These macros are parts of the main program, and of
; depth_1984.s.

        .equ    DEPTH_SIZE, 1           ; words of an object
        .regs   r228, to_primitive, to_crossing, to_object_depth, to_scene_depth
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

; Sets depth_at to the address of the count for the object crossed at
; ray_hit_at.
        .macro  find_object
        LOD     [ray_hit_at, to_primitive], depth_at
        find_count
        .endm

; plane_of, of each form, computes the place of a field of a crossing.
        .macro  load_depth_planes
        plane_of RAY_HIT_PRIMITIVE, to_primitive
        plane_of RAY_HIT_CROSSING, to_crossing
        plane_of RAY_HIT_OBJECT_DEPTH, to_object_depth
        plane_of RAY_HIT_SCENE_DEPTH, to_scene_depth
        .endm

; Processes the crossings of the ray from ray_hit_at on. Their number
; ray_hits_left is at least 1. begin_ray_hits sets both again.
        .macro  count_depths_of_ray
        ES      depth_scene, 0
depths_next\@:
        find_object
        LOD     [ray_hit_at, to_crossing], depth_crossing
        LOD     [depth_at], depth_object
        ADDX    depth_object, depth_crossing, depth_object
        ADDX    depth_scene, depth_crossing, depth_scene
        STO     [depth_at], depth_object
        STO     [ray_hit_at, to_object_depth], depth_object
        STO     [ray_hit_at, to_scene_depth], depth_scene
        next_ray_hit depths_next\@
        begin_ray_hits
depths_clear\@:
        find_object
        STO     [depth_at], r0
        next_ray_hit depths_clear\@
        .endm
