; bodies_vector.s - in how many bodies the queue's lines are behind each crossing.
;
; Column by column, from near to far: the count of a line's bodies of the object that is
; seen there, and that of all, each with the sense there added.  Where a line
; has no such crossing its sense is 0, and nothing changes.
;
; In:  the queue's planes, in order; sort_count.  Out: SEEN_INSIDE, SEEN_WITHIN.
; Source: derived here.

        .equ    INSIDE_SIZE, QUEUE      ; of an object: a count for each line
        .regs   r223, body_index, body_column

; [at] = where the counts of the lines stand, of the objects seen in the column.
        .macro  find_objects at
        CMPLTV  body_index, [line_counts], [bits0]
        ADDX    body_column, line_block, s2
        MASKV   [s2], one_index, [\at] ? [bits0]
        find_records \at, \at, P_OBJECT, s1
        VXTOV   [\at], [s1], [\at]
        EX      s0, INSIDE_SIZE
        MPYLV   [\at], s0, [\at]
        ADDXV   [\at], [s3], [\at]
        .endm

        .macro  columns_begin
        RTOR    seen_first, body_column
        ES      body_index, 0
        .endm

        .macro  columns_next again
        ADDX    body_column, line_stride, body_column
        IBXNE   body_index, one_index, sort_count, \again, body_index
        .endm

; Where the field stands, of the column.
        .macro  column_of field, address
        ES      s0, \field
        MPYX    line_block, s0, \address
        ADDX    body_column, \address, \address
        .endm

        .kernel lines
count_bodies:
        IBXEQ   sort_count, r0, r0, bodies_counted
        set_near n
        describe s3, count_store, n
        load_word lines_inside, s4
        VTOV    r0, [w0]
        columns_begin
bodies_column:
        find_objects w1
        column_of SEEN_SENSE, s2
        VXTOV   [w1], [s4], [w2]
        ADDXV   [w2], [s2], [w2]
        VTOVX   [w1], [w2], [s4]
        ADDXV   [w0], [s2], [w0]
        column_of SEEN_INSIDE, s2
        VTOV    [w2], [s2]
        ADDX    s2, line_block, s2
        VTOV    [w0], [s2]
        columns_next bodies_column
        columns_begin
bodies_clear:
        find_objects w1
        VTOVX   [w1], r0, [s4]
        columns_next bodies_clear
bodies_counted:
        BIM     0, link_kernel
        .endkernel
