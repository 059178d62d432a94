; depth_scalar.s - in how many bodies a line is behind each crossing; see
; depth_vector.s.  Part of the main program.

        .equ    INSIDE_SIZE, 1          ; of an object, in words
        .regs   r232, body_sense, body_at, body_count, body_all

; body_at = where the count of bodies stands, of the object of primitive number body_at.
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

; .. of the object seen at seen_at.
        .macro  find_object
        LOD     [seen_at, m_index_one], body_at
        find_count
        .endm

; The seen_left crossings of the line, from seen_at on, 1 at least.
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
