; faces_vector.s - selects the points of faces.s, STRIP crossings at a time.

        .equ    STRIP, 4096
        .regs   r31, v_distance, v_primitive, v_point, v_sign, v_list, v_signs, v_kept
        .regs   r38, b_near, b_own, b_kept, b_inward, face_n, face_zero, face_inward

        .data
        .align  64
face_store:     .space 3 * STRIP
face_bits:      .space STRIP / 64 * 2
kept_bits:      .space 65536 / 64
inward_bits:    .space 65536 / 64
        .code

        .macro  face_bit bits, number
        describe \bits, face_bits + STRIP * (\number), face_n
        .endm

; Loads the next strip of crossings and marks the near ones in [b_near].
; Branches to `none` if no crossing is left.
        .macro  strip_next none
        IBXEQ   face_left, r0, r0, \none
        at_most STRIP, face_left, face_n
        ADDLEN  face_row, face_n, v_primitive
        ADDX    v_primitive, face_step, v_primitive
        ADDX    v_primitive, face_step, v_point
        ADDX    v_point, face_step, v_sign
        describe v_distance, face_store, face_n
        face_bit b_near, 0
        face_bit b_own, 1
        ADDLEN  face_row, face_n, face_work
        ABSV    [face_work], [v_distance]
        CMPLTV  [v_distance], face_near, [b_near]
        .endm

; Collects the points and directions of the crossings that are in [b_near] and
; [b_own]. Branches to `none` if there are no such crossings.
        .macro  strip_points none
        ANDB    [b_near], [b_own], [b_near]
        if_none b_near, face_count, \none
        describe v_list, face_store, face_count
        describe v_signs, face_store + 64 * STRIP, face_count
        CPSV    [v_point], [v_list] ? [b_near]
        CPSV    [v_sign], [v_signs] ? [b_near]
        .endm

        .macro  strip_done again
        advance_by face_row, face_n, face_work
        SUBX    face_left, face_n, face_left
        BIM     \again
        .endm

        ES      face_zero, 0
        RTOR    face_list, face_row
        RTOR    face_crossings, face_left
faces_own:
        strip_next faces_found
        CMPEQV  [v_primitive], face_primitive, [b_own]
        strip_points faces_marked
        VTOVX   [v_list], [v_signs], [face_kept]
faces_marked:
        strip_done faces_own

faces_found:
        RTOR    face_list, face_row
        RTOR    face_crossings, face_left
faces_other:
        strip_next faces_left
        CMPLTV  [v_primitive], face_primitive, [b_own]
        strip_points faces_cleared
        describe v_kept, face_store + 128 * STRIP, face_count
        VXTOV   [v_list], [face_kept], [v_kept]
        describe b_own, face_bits + STRIP, face_count
        CMPEQV  [v_kept], [v_signs], [b_own]
        if_none b_own, face_count, faces_cleared
        describe face_work, face_store + 64 * STRIP, face_count
        CPSV    [v_list], [face_work] ? [b_own]
        VTOVX   [face_work], face_zero, [face_kept]
faces_cleared:
        strip_done faces_other

faces_left:
        describe b_kept, kept_bits, face_points
        ADDLEN  face_kept, face_points, face_work
        CMPGEV  [face_work], face_one, [b_kept]
        CNTOB   [b_kept], face_count
        describe b_inward, inward_bits, face_points
        ES      face_inward, FACE_INWARD
        CMPEQV  [face_work], face_inward, [b_inward]
        CNTOB   [b_inward], face_left
        ADDLEN  face_from, face_points, face_at
        ADDLEN  face_results, face_count, face_to
faces_plane:
        IBXEQ   face_count, r0, r0, faces_none
        IBXEQ   face_left, r0, r0, faces_as_they_are
        AND     face_vectors, face_one, face_work
        IBXEQ   face_work, r0, r0, faces_as_they_are
        SUBNV   r0, [face_at], [face_at] ? [b_inward]
faces_as_they_are:
        SHIFTI  face_vectors, -1, face_vectors
        CPSV    [face_at], [face_to] ? [b_kept]
faces_none:
        ADDX    face_at, face_stride, face_at
        ADDX    face_to, face_stride, face_to
        IBXNE   face_planes, face_minus_one, r0, faces_plane, face_planes
        STO     [face_to], face_count
        EXIT
