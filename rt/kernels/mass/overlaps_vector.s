; overlaps_vector.s - the overlaps of overlaps.s, LANES crossings at a time.
;
; The counts after all crossings are prefix sums. Each word is added to the word
; that is 1, 2, 4 .. places before it, so that after k steps a word is the sum
; of 2^k words. Zeros precede the first word, which is the count before the
; first crossing.
; Source of the sums: Kogge and Stone 1973, for recurrences.

        .regs   r60, v_counts, v_other, v_before, v_field
        .regs   r64, b_level, b_before, b_after
        .regs   r67, ovl_zero, ovl_n, ovl_distance, ovl_level_bits
        .regs   r71, ovl_at, ovl_left, ovl_level_at, ovl_level_left, ovl_carry
        .regs   r76, ovl_first, ovl_second

        .data
        .align  64
                .space LANES            ; zeros before the counts
counts_store:   .space LANES + 64
                .space LANES            ; zeros before the others
others_store:   .space LANES + 64
field_store:    .space LANES + 64
        .align  64
on_bits:        .space LEVEL_BITS / 64
        .code

; Loads the two words at the address into ovl_first and ovl_second.
        .macro  load_two address
        load_from \address, 2, ovl_first
        .endm

; [v_counts] := the changes of the group's fields at the crossings, after the
; counts before the first crossing.
        .macro  find_steps
        EX      v_counts, counts_store
        LOD     [ovl_carry], col_work0
        STO     [v_counts], col_work0
        IX      v_counts, 64
        ADDLEN  v_counts, col_n, v_counts
        describe v_field, field_store, col_n
        VXTOV   [col_part], [ovl_first], [v_field]
        VTOV    ovl_zero, [v_counts]
        VTOV    [v_field], [v_counts] ? [b_enter]
        SUBXV   ovl_zero, [v_field], [v_counts] ? [b_leave]
        .endm

; [v_counts] := its prefix sums. The last one is kept.
        .macro  add_steps
        describe v_counts, counts_store, ovl_n
        describe v_other, others_store, ovl_n
        ES      ovl_distance, 64
        SHIFTI  ovl_n, 6, col_work1
add_next\@:
        SUBX    v_counts, ovl_distance, v_before
        ADDXV   [v_counts], [v_before], [v_other]
        RTOR    v_counts, v_before
        RTOR    v_other, v_counts
        RTOR    v_before, v_other
        ADDX    ovl_distance, ovl_distance, ovl_distance
        IBXLT   ovl_distance, r0, col_work1, add_next\@
        LOD     [v_counts, col_n], col_work0
        STO     [ovl_carry], col_work0
        .endm

; Makes a descriptor of the bits of a level: before the first crossing, and
; after each crossing.
        .macro  find_bits number, bits
        MPYX    \number, ovl_level_bits, \bits
        ADDX    \bits, ovl_bits, \bits
        ADDLEN  \bits, ovl_n, \bits
        .endm

; Sets [b_enter] to the crossings where the pair at ovl_at turns on, and
; [b_visible] to those where it changes. The bits after the crossings begin one
; bit later than the bits before them.
        .macro  find_changes
        load_two ovl_at                 ; PAIR_LEVELS
        find_bits ovl_first, b_level
        find_bits ovl_second, b_after
        describe b_before, on_bits, ovl_n
        ANDB    [b_level], [b_after], [b_before]
        EX      b_before, on_bits
        ADDX    b_before, col_index_one, b_after
        ADDLEN  b_before, col_n, b_before
        ADDLEN  b_after, col_n, b_after
        XORB    [b_before], [b_after], [b_visible]
        CNTOB   [b_visible], col_count
        .endm

        ES      ovl_zero, 0
        ES      ovl_level_bits, LEVEL_BITS
overlaps_next:
        crossed_next overlaps_fold
        ADDX    col_n, col_index_one, ovl_n
        find_visible col_object_depth
        RTOR    ovl_group, ovl_at
        RTOR    ovl_groups, ovl_left
        RTOR    ovl_levels, ovl_level_at
        RTOR    ovl_carries, ovl_carry
        ADDLEN  ovl_bits, ovl_n, b_level
overlaps_group:
        load_two ovl_at                 ; GROUP_STEPS, GROUP_LEVELS
        find_steps
        add_steps
        RTOR    ovl_second, ovl_level_left
        describe v_field, field_store, ovl_n
overlaps_level:
        load_two ovl_level_at           ; LEVEL_MASK, LEVEL_REACHED
        ANDV    [v_counts], ovl_first, [v_field]
        CMPGEV  [v_field], ovl_second, [b_level]
        IX      ovl_level_at, 64 * LEVEL_SIZE
        IX      b_level, LEVEL_BITS
        IBXNE   ovl_level_left, col_index_minus_one, r0, overlaps_level, ovl_level_left
        IX      ovl_at, 64 * GROUP_SIZE
        IX      ovl_carry, 64
        IBXNE   ovl_left, col_index_minus_one, r0, overlaps_group, ovl_left

        RTOR    ovl_pairs, ovl_at
        RTOR    col_totals, ovl_left
        ADDLEN  col_lanes, col_n, col_at
overlaps_pair:
        find_changes
        IBXEQ   col_count, r0, r0, overlaps_added
        ANDB    [b_visible], [b_after], [b_enter]
        find_weights
        MPYSV   [col_w], [col_s], [col_w]
        ADDNV   [col_at], [col_w], [col_at] ? [b_visible]
overlaps_added:
        IX      col_at, 64 * LANES
        IX      ovl_at, 64 * PAIR_SIZE
        IBXNE   ovl_left, col_index_minus_one, r0, overlaps_pair, ovl_left
        crossed_done overlaps_next

overlaps_fold:
        fold_lanes
        EXIT
