; gaps_scalar.s - the counts of gaps.s, gap by gap.

        .regs   r30, gap_at, gap_near, gap_far, gap_cell

        ES      gap_at, 0
gaps_next:
        LOD     [gap_scene_depths, gap_at], gap_work
        LOD     [gap_distances, gap_at], gap_near
        LOD     [gap_kinds, gap_at], gap_from
        ADDX    gap_at, gap_one, gap_at
        IBXNE   gap_work, r0, r0, gaps_none
        LOD     [gap_distances, gap_at], gap_far
        LOD     [gap_kinds, gap_at], gap_to
        SUBN    gap_far, gap_near, gap_far
        ABS     gap_far, gap_far
        CFPLT   gap_far, gap_least, gaps_none
        MPYX    gap_from, gap_row, gap_cell
        ADDX    gap_counts, gap_cell, gap_cell
        LOD     [gap_cell, gap_to], gap_work
        ADDX    gap_work, gap_one, gap_work
        STO     [gap_cell, gap_to], gap_work
gaps_none:
        IBXNE   gap_at, r0, gap_count, gaps_next
        EXIT
