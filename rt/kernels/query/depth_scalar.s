; depth_scalar.s - counts the bodies that contain a line after each crossing.
;
; See depth_vector.s. These macros are parts of the main program.

        .equ    INSIDE_SIZE, 1          ; words of an object
        .regs   r232, body_sense, body_at, body_count, body_all

; Sets body_at to the address of the body count for the object of the primitive
; whose number is in body_at.
        .macro  find_count
        ES      line_work, P_SIZE
        ADDX    body_at, m_index_minus_one, body_at
        MPYX    body_at, line_work, body_at
        SHIFTI  body_at, 6, body_at
        load_of scene_primitives, line_work
        ADDX    body_at, line_work, body_at
        IX      body_at, 64 * P_OBJECT
        LOD     [body_at], body_at
        SHIFTI  body_at, 6, body_at
        load_of lines_inside, line_work
        ADDX    body_at, line_work, body_at
        .endm

; Sets body_at to the address of the count for the object crossed at seen_at.
        .macro  find_object
        LOD     [seen_at, m_index_one], body_at
        find_count
        .endm

; Processes the crossings of the line from seen_at on. Their number seen_left is
; at least 1.
        .macro  count_bodies_of_line
        ES      body_all, 0
bodies_next\@:
        find_object
        RTOR    seen_at, line_work
        IX      line_work, 64 * SEEN_SENSE
        LOD     [line_work], body_sense
        LOD     [body_at], body_count
        ADDX    body_count, body_sense, body_count
        ADDX    body_all, body_sense, body_all
        STO     [body_at], body_count
        IX      line_work, 64 * (SEEN_OBJECT_DEPTH - SEEN_SENSE)
        STO     [line_work], body_count
        STO     [line_work, m_index_one], body_all
        IX      seen_at, 64 * SEEN_SIZE
        IBXNE   seen_left, m_index_minus_one, r0, bodies_next\@, seen_left
        load_seen
bodies_clear\@:
        find_object
        STO     [body_at], r0
        IX      seen_at, 64 * SEEN_SIZE
        IBXNE   seen_left, m_index_minus_one, r0, bodies_clear\@, seen_left
        load_seen
        .endm
