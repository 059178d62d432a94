; totals.s - adds the sums of packets to the sums of their shifts.
;
; This is the common part of the two forms.
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
        .regs   r17, tot_stride, tot_left, tot_at, tot_work0, tot_work1, tot_row

        .macro  totals_begin
        EX      tot_work0, totals_arguments
        ELEN    tot_work0, TOTALS_ARGUMENTS
        SWAP    [tot_work0], tot_groups, [r0]
        SHIFTI  tot_width, 6, tot_stride
        .endm

        .entry  totals
        by_hand mass/totals
