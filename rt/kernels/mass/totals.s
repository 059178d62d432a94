; totals.s - adds the sums of packets to the sums of their shifts.
;
;   total_g = row_g0 + row_g1 + ..          word by word, in packet order
;
; In:  the words below: total_groups times total_rows rows of total_width words.
; Out: totals_results, total_groups rows.
; Source: derived here.

        .include "points/planes.s"

        .data
totals_arguments:
total_groups:   .word 0                 ; integers
total_rows:     .word 0                 ; of a group
total_width:    .word 0
totals_from:    .word 0                 ; address of the rows
totals_results: .word 0                 ; address of the totals
                .word 1, -1
                .equ    TOTALS_ARGUMENTS, 7
        .code

        .regs   r10, tot_groups, tot_rows, tot_width, tot_from, tot_results
        .regs   r15, tot_index_one, tot_index_minus_one
        .regs   r17, tot_stride, tot_left, tot_i, tot_work, tot_bits
        .regs   r22, total, row, at_row

        planes  tot_i, tot_index_one, tot_width, tot_work, tot_bits

        .entry  totals
        .kernel totals
totals:
        load_words totals_arguments, TOTALS_ARGUMENTS, tot_groups, tot_work
        SHIFTI  tot_width, 6, tot_stride
totals_next:
        plane   tot_results, total
        each    totals_word
        column  tot_from, row
        fetch_into at_row, row, total
        RTOR    tot_rows, tot_left
        BIM     totals_more
totals_row:
        advance row, tot_stride
        fetch   at_row, row
        plus    total, row, total
totals_more:
        IBXNE   tot_left, tot_index_minus_one, r0, totals_row, tot_left
        store   total, tot_results
        next    totals_word
        MPYX    tot_rows, tot_stride, tot_work
        ADDX    tot_results, tot_stride, tot_results
        ADDX    tot_from, tot_work, tot_from
        IBXNE   tot_groups, tot_index_minus_one, r0, totals_next, tot_groups
        EXIT
        .endkernel
