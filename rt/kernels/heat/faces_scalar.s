; faces_scalar.s - selects the points of faces.s, one after another.

        .regs   r31, face_distance, face_own, face_point, face_sign, face_found
        .regs   r36, face_plane_left, face_zero, face_inward, face_turned

; Loads the next crossing. Branches to `none` if none is left, to `far` if it is
; distant.
        .macro  crossing_next none, far
        IBXEQ   face_left, r0, r0, \none
        LOD     [face_row], face_distance
        ADDX    face_row, face_step, face_at
        LOD     [face_at], face_own
        ADDX    face_at, face_step, face_at
        ABS     face_distance, face_distance
        CFPGE   face_distance, face_near, \far
        LOD     [face_at], face_point
        ADDX    face_at, face_step, face_at
        LOD     [face_at], face_sign
        .endm

        .macro  crossing_done again
        IX      face_row, 64
        SUBX    face_left, face_one, face_left
        BIM     \again
        .endm

        ES      face_zero, 0
        ES      face_inward, FACE_INWARD
        RTOR    face_list, face_row
        RTOR    face_crossings, face_left
faces_own:
        crossing_next faces_found, faces_marked
        IBXNE   face_own, r0, face_primitive, faces_marked
        STO     [face_kept, face_point], face_sign
faces_marked:
        crossing_done faces_own

faces_found:
        RTOR    face_list, face_row
        RTOR    face_crossings, face_left
faces_other:
        crossing_next faces_left, faces_cleared
        IBXGE   face_own, r0, face_primitive, faces_cleared
        LOD     [face_kept, face_point], face_found
        IBXNE   face_found, r0, face_sign, faces_cleared
        STO     [face_kept, face_point], face_zero
faces_cleared:
        crossing_done faces_other

faces_left:
        ES      face_count, 0
        ES      face_point, 0
faces_point:
        LOD     [face_kept, face_point], face_found
        IBXEQ   face_found, r0, r0, faces_copied
        RTOR    face_from, face_at
        RTOR    face_results, face_to
        RTOR    face_planes, face_plane_left
        RTOR    face_vectors, face_turned
        IBXEQ   face_found, r0, face_inward, faces_plane
        ES      face_turned, 0
faces_plane:
        LOD     [face_at, face_point], face_work
        AND     face_turned, face_one, face_left
        IBXEQ   face_left, r0, r0, faces_as_it_is
        SUBN    r0, face_work, face_work
faces_as_it_is:
        SHIFTI  face_turned, -1, face_turned
        STO     [face_to, face_count], face_work
        ADDX    face_at, face_stride, face_at
        ADDX    face_to, face_stride, face_to
        IBXNE   face_plane_left, face_minus_one, r0, faces_plane, face_plane_left
        ADDX    face_count, face_one, face_count
faces_copied:
        IBXNE   face_point, face_one, face_points, faces_point, face_point
        MPYX    face_planes, face_stride, face_work
        ADDX    face_results, face_work, face_results
        STO     [face_results], face_count
        EXIT
