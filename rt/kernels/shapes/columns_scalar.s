; columns_scalar.s - sorts the crossings of one ray with a shape that has many,
; by insertion into an ascending list.  The vector form is columns_vector.s.

        .share  local
        .regs   r95, crossed_at, least  ; a crossing; the smallest t that counts
        .regs   r99, list_end, list_last, list_at
        .endshare

        .equ    LIST_REGISTERS, 5

; The list of crossings is ascending, from a_segment to list_last.  If there is
; no room before list_end, the largest one is dropped.
        .macro  begin_list
        RTOR    a_primitive, t0
        IX      t0, 64 * P_SEGMENTS
        LOD     [t0], t0
        ADDX    t0, t0, t0
        SHIFTI  t0, 6, t0
        ADDX    a_segment, t0, list_end
        RTOR    a_segment, list_last
        .endm

        .macro  insert
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
        .macro  leave_list save, registers
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
        leave_segments \save, \registers
        .endm
