; depth_vector.s - counts the bodies that contain the queue's lines.
;
; Processes one column of crossings after another, from near to far, for the
; lines that have a crossing in the column. Each line has a count of its bodies
; for every object and a count for all objects. The sense of a crossing is added
; to the count of its object and to the total.
;
; In:  the queue's planes, in order; sort_count.  Out: SEEN_OBJECT_DEPTH, SEEN_SCENE_DEPTH.
; Source: derived here.

        .equ    INSIDE_SIZE, QUEUE      ; of an object: a count for each line
        .regs   r223, body_index, body_column, body_lines, body_all, body_of

        .data
        .align  64
body_store:     .space 2 * QUEUE
        .code

; Sets body_lines to the lines of the column, and [w1] to the index of each
; line's count for the object that it crosses.
        .macro  find_objects
        describe near_bits, queue_bits, n
        CMPLTV  body_index, [line_counts], [near_bits]
        CNTOB   [near_bits], s6
        set_near s6
        EX      body_lines, body_store
        describe s3, count_store, n
        CPSV    [s3], [body_lines] ? [near_bits]
        ADDX    body_column, line_stride, s2
        VXTOV   [body_lines], [s2], [w1]
        find_records w1, w1, P_OBJECT, s1
        VXTOV   [w1], [s1], [w1]
        EX      s0, INSIDE_SIZE
        MPYLV   [w1], s0, [w1]
        ADDXV   [w1], [body_lines], [w1]
        .endm

; Computes the address of a field's plane in the column.
        .macro  column_of field, address
        ES      s0, \field
        MPYX    line_stride, s0, \address
        ADDX    body_column, \address, \address
        .endm

; Adds the senses [w2] to the counts at [index]. Stores the sums in `plane` too.
        .macro  add_senses index, counts, plane
        VXTOV   [\index], [\counts], [w3]
        ADDXV   [w3], [w2], [w3]
        VTOVX   [\index], [w3], [\counts]
        VTOVX   [body_lines], [w3], [\plane]
        .endm

        .macro  columns_begin
        RTOR    seen_first, body_column
        ES      body_index, 0
        .endm

        .macro  columns_next again
        ADDX    body_column, line_step, body_column
        IBXNE   body_index, one_index, sort_count, \again, body_index
        .endm

        .kernel lines
count_bodies:
        IBXEQ   sort_count, r0, r0, bodies_counted
        load_word lines_inside, body_of
        describe body_all, body_store + 64 * QUEUE, n
        VTOV    r0, [body_all]
        columns_begin
bodies_column:
        find_objects
        column_of SEEN_SENSE, s2
        VXTOV   [body_lines], [s2], [w2]
        column_of SEEN_OBJECT_DEPTH, s2
        add_senses w1, body_of, s2
        ADDX    s2, line_stride, s2
        add_senses body_lines, body_all, s2
        columns_next bodies_column
        columns_begin
bodies_clear:
        find_objects
        VTOVX   [w1], r0, [body_of]
        columns_next bodies_clear
bodies_counted:
        BIM     0, link_kernel
        .endkernel
