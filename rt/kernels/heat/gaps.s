; gaps.s - counts pairs of surfaces that face each other along lines.
;
; This is the common part of the two forms. The ends of gaps are crossings, and
; ends that represent the environment. They are in the order of lines, and along
; a line from near to far. Gap k extends from end k to end k + 1. It is empty if
; no body contains the line after end k. Gaps shorter than `least` are ignored:
;
;   count_ij = number of k with  surface_k = i,  surface_(k+1) = j,
;              within_k = 0,  |distance_(k+1) - distance_k| >= least
;
; In:  the words below.
; Out: gaps_counts, a row of counts for each surface i.
; Source: M. Sbert, "An integral geometry based method for fast form-factor
; computation" (1993); the program is derived here.

; The planes of an end.
        .include "points/planes.s"

        .record GAP_END
        .field  GAP_DISTANCE            ; along the line
        .field  GAP_SURFACE             ; an integer from 0
        .field  GAP_SCENE_DEPTH         ; number of bodies that contain the line
                                        ; after it, an integer
        .endrecord

        .data
gaps_arguments:
gaps_count:     .word 0                 ; ends less one, 1 .. 65534, an integer
gaps_surfaces:  .word 0                 ; surfaces, including the environment
gaps_ends:      .word 0                 ; address of the planes of ends
gaps_counts:    .word 0                 ; address of the counts, zeros
gaps_buffer:    .word 0                 ; address of three words for each gap
gaps_least:     .word 0                 ; a length
                .word 1
                .equ    GAPS_ARGUMENTS, 7
        .code

        .regs   r10, gap_count, gap_surfaces, gap_distances, gap_counts, gap_buffer, gap_least, gap_one
        .regs   r17, gap_kinds, gap_scene_depths, gap_from, gap_to, gap_row, gap_work

        .entry  gaps
        .kernel gaps
gaps:
        load_words gaps_arguments, GAPS_ARGUMENTS, gap_count, gap_work
        ADDX    gap_count, gap_one, gap_work
        SHIFTI  gap_work, 6, gap_work
        ADDX    gap_distances, gap_work, gap_kinds
        ADDX    gap_kinds, gap_work, gap_scene_depths
        SHIFTI  gap_surfaces, 6, gap_row
        by_hand heat/gaps
        .endkernel
