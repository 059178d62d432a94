; overlaps_scalar.s - the overlaps of overlaps.s, one crossing after another.

        .regs   r60, ovl_level, ovl_level_left, ovl_count       ; of PART
        .regs   r63, ovl_least, ovl_on, ovl_partner, ovl_left   ; of LEVEL
        .regs   r67, ovl_other, ovl_pair                        ; of PARTNER
        .regs   r69, ovl_part_at, ovl_at, ovl_term, ovl_zero

; Loads `count` consecutive fields at the address, from `first` on, into
; registers.
        .macro  load_fields address, first, count, register
        load_part \address, \first, \count, \register, ovl_at
        .endm

; Adds the term to the lanes of the level's pairs whose other level is on.
        .macro  add_pairs
partner_next\@:
        load_fields ovl_partner, 0, PARTNER_SIZE, ovl_other
        IX      ovl_other, 64 * LEVEL_ON
        LOD     [ovl_other], ovl_on
        IBXEQ   ovl_on, r0, r0, partner_off\@
        ES      ovl_at, LANES
        MPYX    ovl_pair, ovl_at, ovl_at
        ADDX    ovl_at, col_lane, ovl_at
        LOD     [col_lanes, ovl_at], col_work0
        ADDN    col_work0, ovl_term, col_work0
        STO     [col_lanes, ovl_at], col_work0
partner_off\@:
        IX      ovl_partner, 64 * PARTNER_SIZE
        IBXNE   ovl_left, col_index_minus_one, r0, partner_next\@, ovl_left
        .endm

; Turns levels of the part on (1) after an entry, or off (0) after an exit.
        .macro  change_levels enters
level_next\@:
        load_fields ovl_level, LEVEL_MIN, 4, ovl_least
        IBXNE   ovl_count, r0, ovl_least, level_done\@
        address_of ovl_level, LEVEL_ON, ovl_at
        .if     \enters
        STO     [ovl_at], col_index_one
        .endif
        add_pairs
        .if     \enters == 0
        address_of ovl_level, LEVEL_ON, ovl_at
        STO     [ovl_at], ovl_zero
        .endif
level_done\@:
        IX      ovl_level, 64 * LEVEL_SIZE
        IBXNE   ovl_level_left, col_index_minus_one, r0, level_next\@, ovl_level_left
        .endm

        ES      ovl_zero, 0
overlaps_next:
        crossed_next overlaps_fold
        find_weight col_object_depth, overlaps_done
        ES      ovl_part_at, 64 * PART_SIZE
        MPYX    col_part, ovl_part_at, ovl_part_at
        ADDX    ovl_parts, ovl_part_at, ovl_part_at
        load_fields ovl_part_at, 0, PART_SIZE, ovl_level
        IBXEQ   ovl_level_left, r0, r0, overlaps_done
        MPYS    col_w, col_s, ovl_term
        IX      ovl_part_at, 64 * PART_COUNT
        IBXNE   col_sign, r0, col_index_one, overlaps_leaves
        ADDX    ovl_count, col_index_one, ovl_count
        STO     [ovl_part_at], ovl_count
        change_levels 1
        BIM     overlaps_done
overlaps_leaves:
        ADDX    ovl_count, col_index_minus_one, ovl_on
        STO     [ovl_part_at], ovl_on
        change_levels 0
overlaps_done:
        crossed_done overlaps_next

overlaps_fold:
        fold_lanes
        EXIT
