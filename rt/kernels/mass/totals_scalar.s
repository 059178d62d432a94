; totals_scalar.s - the totals of totals.s, word by word.

        .kernel totals
totals:
        totals_begin
totals_next:
        ES      tot_at, 0
totals_word:
        RTOR    tot_from, tot_row
        LOD     [tot_row, tot_at], tot_work0
        RTOR    tot_rows, tot_left
        BIM     totals_more
totals_row:
        ADDX    tot_row, tot_stride, tot_row
        LOD     [tot_row, tot_at], tot_work1
        ADDN    tot_work0, tot_work1, tot_work0
totals_more:
        IBXNE   tot_left, tot_index_minus_one, r0, totals_row, tot_left
        STO     [tot_results, tot_at], tot_work0
        IBXNE   tot_at, tot_index_one, tot_width, totals_word, tot_at
        ADDX    tot_row, tot_stride, tot_from
        ADDX    tot_results, tot_stride, tot_results
        IBXNE   tot_groups, tot_index_minus_one, r0, totals_next, tot_groups
        EXIT
        .endkernel
