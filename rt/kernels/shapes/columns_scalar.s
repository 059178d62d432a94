; columns_scalar.s - sorts the crossings of one ray with a shape that has many,
; by insertion into an ascending list.  The vector form is columns_vector.s.

        .ifndef LIST_REGISTERS
        include_form lanes

        .share  local
        .regs   r95, crossed_at, least  ; a crossing; the smallest t that counts
        .regs   r99, list_end, list_last, list_at
        .regs   r79, row0, row1, row2, row3, row4       ; a row of the table
        .regs   r84, lane_at, lane_ox, lane_oy, lane_oz, lane_dx, lane_dy, lane_dz
        .regs   r91, lane_along, lane_low, lane_high    ; values of the ray
        .regs   r97, set4, set0                         ; sets it may belong to
        .regs   r102, set1, set2, set3
        .regs   r105, row5, row6, row7, row8, row9, row10, row11, row12, row13
        .regs   r114, row14, row15, row16, row17
        .endshare
        .reg    queue_low, lane_low             ; the range of all rays
        .reg    queue_high, lane_high

        .equ    LIST_REGISTERS, 5

; The list of crossings is ascending, from a_segment to list_last.  If there is
; no room before list_end, the largest one is dropped.
        .macro  begin_columns
        load_of a_primitive, P_SEGMENTS, t0
        ADDX    t0, t0, t0
        SHIFTI  t0, 6, t0
        ADDX    a_segment, t0, list_end
        RTOR    a_segment, list_last
        .endm

        .macro  insert  bits=
        IBXNE   list_last, r0, list_end, insert_here\@
        IX      list_last, -64
        LOD     [list_last], t1
        CFPLT   crossed_at, t1, insert_here\@
        IX      list_last, 64
        BIM     insert_done\@
insert_here\@:
        RTOR    list_last, list_at
        IX      list_last, 64
insert_next\@:
        IBXEQ   list_at, r0, a_segment, insert_store\@
        IX      list_at, -64
        LOD     [list_at], t1
        CFPGE   crossed_at, t1, insert_after\@
        STO     [list_at, index_one], t1
        BIM     insert_next\@
insert_after\@:
        IX      list_at, 64
insert_store\@:
        STO     [list_at], crossed_at
insert_done\@:
        .endm

; Repeats the last crossing if their number is odd, then fills the list with
; misses.
        .macro  leave_columns shape
        SUBX    list_last, a_segment, t0
        SHIFTI  t0, -6, t0
        AND     t0, index_one, t0
        IBXEQ   t0, r0, r0, list_even\@
        IX      list_last, -64
        LOD     [list_last], t1
        STO     [list_last, index_one], t1
        IX      list_last, 64 * 2
list_even\@:
        IBXEQ   list_last, r0, list_end, list_filled\@
        STO     [list_last], big
        STO     [list_last, index_one], minus_big
        IX      list_last, 64 * 2
        BIM     list_even\@
list_filled\@:
        leave_segments \shape\()_save, \shape\()_registers
        .endm

; One ray needs no code for these operations.
        no_code all_lanes
        no_code set_ahead
        no_code note_side
        no_code keep_set_before
        no_code range_of_queue
        no_code note_negative
        no_code none_in
        no_code keep_within
        no_code skip_both

        .macro  if_any_less_number a, k, set, label
        CFPGE   \a, \k, \label
        .endm

        .macro  mark_side a, left
        ES      \left, 0
        CFPLT   \a, r0, marked\@
        ES      \left, 1
marked\@:
        .endm

        .macro  if_side_changes a, before, left, left_before, set, out
        CFPGE   \a, r0, side_left\@
        CFPLT   \before, r0, \out
        BIM     side_changes\@
side_left\@:
        CFPGE   \before, r0, \out
side_changes\@:
        .endm

        .macro  keep_before a, before
        RTOR    \a, \before
        .endm

        .macro  find_turning bend, lead, left, once, twice, out
        IBXNE   \once, r0, r0, turning\@
        ADDN    \lead, \bend, t0
        CFPLT   \lead, r0, turning_falls\@
        IBXNE   \left, r0, r0, \out
        CFPGE   t0, r0, \out
        BIM     turning\@
turning_falls\@:
        IBXEQ   \left, r0, r0, \out
        CFPLT   t0, r0, \out
turning\@:
        .endm

        .macro  keep_positive a, twice, once, out
        CFPLT   r0, \a, positive\@
        IBXEQ   \once, r0, r0, \out
positive\@:
        .endm

        .macro  sum_away b, root, q, set
        ABS     \b, third
        ADDN    third, \root, \q
        CFPLT   \b, r0, away\@
        SUBN    r0, \q, \q
away\@:
        .endm

        .macro  turned_by b, set, chosen
        RTOR    \set, \chosen
        CFPLT   \b, r0, turned_by\@
        XOR     \chosen, index_one, \chosen
turned_by\@:
        .endm

        .macro  leave_at_nearest shape, miss
        CFPGE   tin, big, \miss
        RTOR    tin, tout
        leave_solver \shape\()_save, \shape\()_registers
        .endm

        .macro  missed_columns label, shape
\label:
        miss_near \shape\()_save, \shape\()_registers
        .endm

        .macro  fill_columns shape, passed, fill
        BIM     \fill
\passed:
        begin_columns
\fill:
        leave_columns \shape
        .endm

; ---- Lathes ------------------------------------------------------------------

        .macro  unless_zero a, set, zero
        CFPEQ   \a, r0, \zero
        .endm

        .macro  keep_real a, set, out
        CFPLT   \a, r0, \out
        .endm

        .macro  quotient_outside set, a, b, c
        DIVS    \a, \b, \c
        .endm

        .macro  reciprocal_or_one a, c
        RTOR    one, \c
        CFPEQ   \a, r0, reciprocal\@
        DIVS    one, \a, \c
reciprocal\@:
        .endm

        .macro  either_two_if_negative number, set, a, b, c, x, y, z
        RTOR    \b, \c
        RTOR    \y, \z
        CFPGE   \number, r0, either\@
        RTOR    \a, \c
        RTOR    \x, \z
either\@:
        .endm

        .macro  either_two_by number, set, a, b, c, x, y, z
        CFPNE   \number, r0, either_by\@
        XOR     \set, index_one, \set
either_by\@:
        either_two \set, \a, \b, \c, \x, \y, \z
        .endm

        .macro  begin_clear set
        ES      \set, 0
        .endm

        .macro  end_clear set, far
\far:
        .endm

        .macro  mark_less_scaled a, b, k, set, out
        MPYS    \b, \k, third
        CFPGE   \a, third, \out
        ES      \set, 1
        .endm

        .macro  find_twice once, inside, inside_before, twice, out
        AND     \inside, \inside_before, third
        IBXNE   third, r0, r0, \out
        .endm

        .macro  unless_once once, label
        IBXNE   \once, r0, r0, \label
        .endm

        .macro  opposite a
        SUBN    r0, \a, \a
        .endm

        condition keep_opposite_not_less, CFPLT
        condition keep_opposite_less, CFPGE

        .macro  turned_if_negative number, set, chosen
        turn_if_less \number, r0, \set, \chosen
        .endm

        .macro  subset_less a, b, set, subset, out
        CFPGE   \a, \b, \out
        .endm

        .macro  missed_by_all label, shape
        missed_columns \label, \shape
        .endm
        .endif
