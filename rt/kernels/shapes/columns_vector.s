; columns_vector.s - sorts the crossings of a queue with a shape that has many.
; They are found in any order and kept ascending in columns by exchanges: two
; columns for each of the P_SEGMENTS segments, from tin on.
;
; Source: derived here (insertion sort, one step for all rays at a time).

        .reg    crossed_at, k3          ; a crossing of each ray
        .reg    column_work, k0
        .reg    columns_used, s2
        .reg    column_at, s8
        .reg    columns_left, s9

        .equ    SEGMENT_COLUMNS, 2

        .macro  trade a, b
        RTOR    \a, s0
        RTOR    \b, \a
        RTOR    s0, \b
        .endm

        .macro  first_column
        RTOR    tin, column_at
        load_field P_SEGMENTS, columns_left
        .endm

        .macro  next_column
        EX      s0, 64 * CROSSING_SIZE
        ADDX    column_at, s0, column_at
        .endm

        .macro  next_segment again
        IBXNE   columns_left, minus_one_index, r0, \again, columns_left
        .endm

        .macro  clear_columns
        ES      columns_used, 0
        first_column
clear_column\@:
        VTOV    big, [column_at]
        next_column
        VTOV    big, [column_at]
        next_column
        next_segment clear_column\@
        .endm

; Keeps the smaller of the column and [crossed_at]; the larger moves to the next
; column.
        .macro  exchange_column
        CMPLTV  [crossed_at], [column_at], [bits0]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, column_kept\@
        MASKV   [column_at], [crossed_at], [column_work] ? [bits0]
        VTOV    [crossed_at], [column_at] ? [bits0]
        trade   crossed_at, column_work
column_kept\@:
        next_column
        .endm

; Inserts [crossed_at] into the columns in the lanes of bits.  Each call may use
; one more column than the previous one.
        .macro  insert bits
        MASKV   [crossed_at], big, [crossed_at] ? [\bits]
        first_column
        ADDX    columns_left, columns_left, columns_left
        IBXEQ   columns_used, r0, columns_left, insert_used\@
        ADDX    columns_used, one_index, columns_used
        RTOR    columns_used, columns_left
insert_used\@:
        exchange_column
        next_segment insert_used\@
        .endm

; Completes the segments: a segment without a second crossing ends where it
; begins; one without any is a miss.
        .macro  leave_columns
        first_column
fill_segment\@:
        RTOR    column_at, s2
        next_column
        CMPGEV  [column_at], big, [bits0]
        VTOV    [s2], [column_at] ? [bits0]
        CMPGEV  [column_at], big, [bits0]
        VTOV    minus_big, [column_at] ? [bits0]
        next_column
        next_segment fill_segment\@
        BIM     0, link_kernel
        .endm
