; columns_vector.s - sorts the crossings of a queue with a shape that has many.
; They are found in any order and kept ascending in columns by exchanges: two
; columns for each of the P_SEGMENTS segments, from tin on.
;
; Source: derived here (insertion sort, one step for all rays at a time).

        .ifndef SEGMENT_COLUMNS
        include_form lanes

        .reg    crossed_at, k3          ; a crossing of each ray
        .reg    column_work, k0
        .reg    columns_used, s2
        .reg    column_at, s8
        .reg    columns_left, s9

; Words of a row of the table, and sets.
        .reg    row0, s3
        .reg    row1, s4
        .reg    row2, s5
        .reg    row3, s6
        .reg    row4, s7
        .share  shape
        .regs   r43, row5, row6, row7, row8, row9, row10, row11, row12, row13
        .regs   r52, row14, row15, row16, row17
        .endshare
        .share  hits
        .regs   r164, set0, set1, set2, set3
        .endshare
        .reg    set4, bits2
        .reg    queue_low, s3                   ; the range of all rays
        .reg    queue_high, s4

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

        .macro  begin_columns
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
        if_none bits0, s0, column_kept\@
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
        .macro  leave_columns shape
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

        .macro  all_lanes
        set_lanes near
        .endm

; What follows, up to label, is for the rays with a < k: the set.
        .macro  if_any_less_number a, k, set, label
        CMPLTV  [\a], \k, [\set]
        skip_empty \set, \label
        .endm

; set = the rays of `all` with a >= b, which is so for all that did not miss.
        .macro  set_ahead a, b, set, all
        CMPGEV  [\a], [\b], [\set]
        ANDB    [\all], [\set], [\set]
        .endm

; left = the rays with a >= 0.
        .macro  note_side a, left
        CMPGEV  [\a], r0, [\left]
        .endm

; The same; the set is a word in the scalar form.
        .macro  mark_side a, left
        CMPGEV  [\a], r0, [\left]
        .endm

; set = the rays for which exactly one of a and `before` is >= 0.
        .macro  if_side_changes a, before, left, left_before, set, out
        XORB    [\left], [\left_before], [\set]
        skip_empty \set, \out
        .endm

; before = a, whose place is used again.
        .macro  keep_before a, before
        trade   \a, \before
        .endm

        .macro  keep_set_before set, before
        trade   \set, \before
        .endm

; twice = the rays, not in once, for which a polynomial with slope lead at its
; begin and lead + bend at its end first approaches 0, then turns.  w1 changes.
        .macro  find_turning bend, lead, left, once, twice, out
        ADDNV   [\lead], [\bend], [t1]
        CMPLTV  [\lead], r0, [bits0]
        CMPLTV  [t1], r0, [\twice]
        XORB    [bits0], [\twice], [\twice]
        XORB    [\left], [bits0], [bits0]
        ORB     [bits0], [\once], [bits0]
        ANDNB   [\twice], [bits0], [\twice]
        skip_both \twice, \once, \out
        .endm

        .macro  skip_both set, other, out
        ORB     [\set], [\other], [bits0]
        skip_empty bits0, \out
        .endm

; Keeps the rays of twice with a > 0.
        .macro  keep_positive a, twice, once, out
        CMPLTV  r0, [\a], [bits0]
        ANDB    [bits0], [\twice], [\twice]
        skip_both \twice, \once, \out
        .endm

; q = -(b + sign(b) root), sign(0) = +; set = the rays with b >= 0.
        .macro  sum_away b, root, q, set
        ADDNV   |[\b]|, [\root], [\q]
        CMPGEV  [\b], r0, [\set]
        VTOV    -[\q], [\q] ? [\set]
        .endm

; chosen: in the set, or b >= 0, but not both.  sum_away has computed b >= 0 in
; chosen.
        .macro  turned_by b, set, chosen
        XORB    [\chosen], [\set], [\chosen]
        .endm

; tout = tin, or a miss.
        .macro  leave_at_nearest shape, miss
        CMPLTV  [tin], big, [bits0]
        VTOV    minus_big, [tout]
        VTOV    [tin], [tout] ? [bits0]
        BIM     0, link_kernel
        .endm

        no_code missed_columns

        .macro  fill_columns shape, passed, fill
\fill:
        leave_columns \shape
        .endm

; ---- Lathes ------------------------------------------------------------------

; queue_low, queue_high = the range of low and high of all rays.
        .macro  range_of_queue low, high
        MINV    [\low], s0, queue_low
        MAXV    [\high], s0, queue_high
        .endm

        .macro  note_negative a, set
        CMPLTV  [\a], r0, [\set]
        .endm

; set = the rays with a = 0, which branch to zero.
        .macro  unless_zero a, set, zero
        CMPEQV  [\a], r0, [\set]
        .endm

; set = the rays with a < 0, which miss; their a becomes 0.
        .macro  keep_real a, set, out
        CMPLTV  [\a], r0, [\set]
        VTOV    r0, [\a] ? [\set]
        .endm

        .macro  quotient_outside set, a, b, c
        MASKV   one, [\b], [\c] ? [\set]
        DIVSV   [\a], [\c], [\c]
        .endm

        .macro  reciprocal_or_one a, c
        CMPEQV  [\a], r0, [bits0]
        MASKV   one, [\a], [\c] ? [bits0]
        DIVSV   one, [\c], [\c]
        .endm

; set = the rays with number < 0.
        .macro  either_two_if_negative number, set, a, b, c, x, y, z
        either_two \set, \a, \b, \c, \x, \y, \z
        .endm

; The same for the other rays if number is 0.
        .macro  either_two_by number, set, a, b, c, x, y, z
        CFPEQ   \number, r0, either_others\@
        either_two \set, \a, \b, \c, \x, \y, \z
        BIM     either_by\@
either_others\@:
        either_two \set, \b, \a, \c, \y, \x, \z
either_by\@:
        .endm

; Nothing is between low and high for the rays of the set.
        .macro  none_in set, low, high
        VTOV    big, [\low] ? [\set]
        VTOV    minus_big, [\high] ? [\set]
        .endm

; The set is empty from far on; what begin_clear precedes, computes it.
        no_code begin_clear

        .macro  end_clear set, far
        BIM     cleared\@
\far:
        XORB    [\set], [\set], [\set]
cleared\@:
        .endm

; set = the rays with a < b k.
        .macro  mark_less_scaled a, b, k, set, out
        LINKV
        MPYSV   [\b], \k, [\b]
        CMPLTV  [\a], [\b], [\set]
        .endm

; Keeps the rays of the set with low <= at <= high.
        .macro  keep_within at, low, high, set
        CMPGEV  \at, [\low], [bits0]
        CMPGEV  [\high], \at, [bits1]
        ANDB    [bits0], [\set], [\set]
        ANDB    [bits1], [\set], [\set]
        .endm

; twice = the rays that may cross an edge twice: they reach its heights, and
; neither end is inside.
        .macro  find_twice once, inside, inside_before, twice, out
        CMPGEV  [ray_high], row_low, [bits0]
        CMPGEV  row_high, [ray_low], [bits1]
        ANDB    [bits0], [bits1], [\twice]
        ORB     [\inside], [\inside_before], [bits0]
        ANDNB   [\twice], [bits0], [\twice]
        skip_both \twice, \once, \out
        .endm

        no_code unless_once

; The vector form compares with -a.
        no_code opposite

        .macro  keep_opposite_not_less a, b, set, out
        CMPGEV  -[\a], [\b], [bits0]
        ANDB    [bits0], [\set], [\set]
        .endm

        .macro  keep_opposite_less a, b, set, out
        CMPLTV  -[\a], [\b], [bits0]
        ANDB    [bits0], [\set], [\set]
        .endm

; Removes or adds the rays of the set, which have number < 0.
        .macro  turned_if_negative number, set, chosen
        XORB    [\chosen], [\set], [\chosen]
        .endm

; subset = the rays of the set with a < b.
        .macro  subset_less a, b, set, subset, out
        CMPLTV  [\a], [\b], [bits0]
        ANDB    [bits0], [\set], [\subset]
        .endm

        .macro  missed_by_all label, shape
\label:
        miss_near
        .endm
        .endif
