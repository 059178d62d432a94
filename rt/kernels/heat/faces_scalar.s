; faces_scalar.s - the points of faces.s that stay, one after another.

        .include "heat/faces.s"

        .regs   r30, face_distance, face_own, face_point
        .regs   r33, face_plane, face_next, face_plane_left

        .entry  faces
        .kernel faces
faces:
        faces_begin
faces_next:
        IBXEQ   face_left, r0, r0, faces_found
        ADDX    face_list, face_step, face_at
        LOD     [face_list], face_distance
        LOD     [face_at], face_own
        ADDX    face_at, face_step, face_at
        LOD     [face_at], face_point
        ABS     face_distance, face_distance
        IBXNE   face_own, r0, face_primitive, faces_marked
        CFPGE   face_distance, face_near, faces_marked
        STO     [face_kept, face_point], face_one
faces_marked:
        IX      face_list, 64
        SUBX    face_left, face_one, face_left
        BIM     faces_next

faces_found:
        ES      face_count, 0
        ES      face_point, 0
faces_point:
        LOD     [face_kept, face_point], face_own
        IBXNE   face_own, r0, face_one, faces_copied
        RTOR    face_from, face_at
        RTOR    face_made, face_to
        RTOR    face_planes, face_plane_left
faces_plane:
        LOD     [face_at, face_point], face_work
        STO     [face_to, face_count], face_work
        ADDX    face_at, face_stride, face_at
        ADDX    face_to, face_stride, face_to
        IBXNE   face_plane_left, face_minus_one, r0, faces_plane, face_plane_left
        ADDX    face_count, face_one, face_count
faces_copied:
        IBXNE   face_point, face_one, face_points, faces_point, face_point
        MPYX    face_planes, face_stride, face_work
        ADDX    face_made, face_work, face_made
        STO     [face_made], face_count
        EXIT
        .endkernel
