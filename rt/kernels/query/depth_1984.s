; depth_1984.s - counts the bodies that contain each line, line by line.
;
; Computes the same as depth_vector.s, in kernels mode.

        .share  loop
        .regs   r225, line_work, seen_at, seen_left
        .regs   r228, to_primitive, to_sense, to_inside, to_within
        .endshare

        .macro  plane_of field, into
        ES      \into, \field
        MPYX    \into, to_stride, \into
        .endm

; Sets body_at to the address of the count for the object crossed at seen_at.
        .macro  find_object_there
        LOD     [seen_at, to_primitive], body_at
        find_count
        .endm

; Finds the first crossing of the line. Branches to `none` if it has no
; crossing.
        .macro  begin_seen none
        LOD     [to_counts, loop_index], seen_left
        IBXEQ   seen_left, r0, r0, \none
        SHIFTI  loop_index, 6, seen_at
        ADDX    seen_at, to_first, seen_at
        .endm

        .macro  next_seen again
        ADDX    seen_at, to_step, seen_at
        IBXNE   seen_left, m_index_minus_one, r0, \again, seen_left
        .endm

        .kernel lines
count_bodies:
        hand_over line_stride, SEEN_OPERANDS, 0, seen_operands
        to_scalar
        load_at seen_operands, SEEN_OPERANDS, to_stride
        SHIFTI  to_stride, -6, to_stride        ; in words, like indices
        plane_of SEEN_PRIMITIVE, to_primitive
        plane_of SEEN_SENSE, to_sense
        plane_of SEEN_OBJECT_DEPTH, to_inside
        plane_of SEEN_SCENE_DEPTH, to_within
        RTOR    n, loop_count
        ES      loop_index, 0
bodies_line:
        begin_seen bodies_none
        ES      body_all, 0
bodies_next:
        find_object_there
        LOD     [seen_at, to_sense], body_sense
        LOD     [body_at], body_count
        ADDX    body_count, body_sense, body_count
        ADDX    body_all, body_sense, body_all
        STO     [body_at], body_count
        STO     [seen_at, to_inside], body_count
        STO     [seen_at, to_within], body_all
        next_seen bodies_next
        begin_seen bodies_none
bodies_clear:
        find_object_there
        STO     [body_at], r0
        next_seen bodies_clear
bodies_none:
        loop_next bodies_line
        to_vector
        BIM     0, link_kernel
        .endkernel
