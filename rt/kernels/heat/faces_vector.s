; faces_vector.s - the points of faces.s that stay, STRIP crossings at a time.

        .include "heat/faces.s"

        .equ    STRIP, 4096
        .regs   r30, v_distance, v_primitive, v_point, v_list, b_near, b_own, b_kept
        .regs   r37, face_n

        .data
        .align  64
face_store:     .space 2 * STRIP
face_bits:      .space STRIP / 64 * 2
kept_bits:      .space 65536 / 64
        .code

        .macro  face_vector vector, number
        EX      \vector, face_store + 64 * STRIP * (\number)
        ADDLEN  \vector, face_n, \vector
        .endm

        .macro  face_bit bits, number
        EX      \bits, face_bits + STRIP * (\number)
        ADDLEN  \bits, face_n, \bits
        .endm

        .entry  faces
        .kernel faces
faces:
        faces_begin
faces_next:
        IBXEQ   face_left, r0, r0, faces_found
        EX      face_n, STRIP
        IBXLE   face_n, r0, face_left, faces_full
        RTOR    face_left, face_n
faces_full:
        ADDLEN  face_list, face_n, v_primitive
        ADDX    v_primitive, face_step, v_primitive
        ADDX    v_primitive, face_step, v_point
        face_vector v_distance, 0
        face_bit b_near, 0
        face_bit b_own, 1
        ADDLEN  face_list, face_n, face_work
        ABSV    [face_work], [v_distance]
        CMPLTV  [v_distance], face_near, [b_near]
        CMPEQV  [v_primitive], face_primitive, [b_own]
        ANDB    [b_near], [b_own], [b_near]
        CNTOB   [b_near], face_count
        IBXEQ   face_count, r0, r0, faces_marked
        EX      v_list, face_store + 64 * STRIP
        ADDLEN  v_list, face_count, v_list
        CPSV    [v_point], [v_list] ? [b_near]
        VTOVX   [v_list], face_one, [face_kept]
faces_marked:
        SHIFTI  face_n, 6, face_work
        ADDX    face_list, face_work, face_list
        SUBX    face_left, face_n, face_left
        BIM     faces_next

faces_found:
        EX      b_kept, kept_bits
        ADDLEN  b_kept, face_points, b_kept
        ADDLEN  face_kept, face_points, face_work
        CMPEQV  [face_work], face_one, [b_kept]
        CNTOB   [b_kept], face_count
        ADDLEN  face_from, face_points, face_at
        ADDLEN  face_made, face_count, face_to
faces_plane:
        IBXEQ   face_count, r0, r0, faces_none
        CPSV    [face_at], [face_to] ? [b_kept]
faces_none:
        ADDX    face_at, face_stride, face_at
        ADDX    face_to, face_stride, face_to
        IBXNE   face_planes, face_minus_one, r0, faces_plane, face_planes
        STO     [face_to], face_count
        EXIT
        .endkernel
