; totals_vector.s - the totals of totals.s, row by row, of at most 65535 words.

        .kernel totals
totals:
        totals_begin
totals_next:
        ADDLEN  tot_results, tot_width, tot_at
        ADDLEN  tot_from, tot_width, tot_row
        VTOV    [tot_row], [tot_at]
        RTOR    tot_rows, tot_left
        BIM     totals_more
totals_row:
        ADDLEN  tot_from, tot_width, tot_row
        ADDNV   [tot_at], [tot_row], [tot_at]
totals_more:
        ADDX    tot_from, tot_stride, tot_from
        IBXNE   tot_left, tot_index_minus_one, r0, totals_row, tot_left
        ADDX    tot_results, tot_stride, tot_results
        IBXNE   tot_groups, tot_index_minus_one, r0, totals_next, tot_groups
        EXIT
        .endkernel
