; gaps.s - which surfaces face each other along lines; what the two forms have in common.
;
; The ends of gaps, crossings and what stands for the environment, lie in the order of
; lines, and along a line from near to far.  Gap k reaches from end k to end k + 1, and is
; empty where no body is behind end k; one shorter than `least` is none:
;
;   count_ij = how many k have  surface_k = i,  surface_(k+1) = j,  within_k = 0,
;                               |distance_(k+1) - distance_k| >= least
;
; In:  what stands below.
; Out: gaps_counts, a row of counts for each surface i.
; Source: M. Sbert, "An integral geometry based method for fast form-factor computation"
; (1993); the program is derived here.

; The planes of an end.
        .record GAP_END
        .field  GAP_DISTANCE            ; along the line
        .field  GAP_SURFACE             ; an integer from 0 on
        .field  GAP_WITHIN              ; in how many bodies the line is behind it, likewise
        .endrecord

        .data
gaps_given:
gaps_count:     .word 0                 ; one less than ends, 1 .. 65534, an integer
gaps_surfaces:  .word 0                 ; .. surfaces, the environment among them
gaps_ends:      .word 0                 ; address of the planes of ends
gaps_counts:    .word 0                 ; .. of the counts, zeros
gaps_room:      .word 0                 ; .. of three words for each gap
gaps_least:     .word 0                 ; a length
                .word 1
                .equ    GAPS_GIVEN, 7
        .code

        .regs   r10, gap_count, gap_surfaces, gap_distances, gap_counts, gap_room, gap_least, gap_one
        .regs   r17, gap_kinds, gap_withins, gap_from, gap_to, gap_row, gap_work

        .macro  gaps_begin
        EX      gap_work, gaps_given
        ELEN    gap_work, GAPS_GIVEN
        SWAP    [gap_work], gap_count, [r0]
        ADDX    gap_count, gap_one, gap_work
        SHIFTI  gap_work, 6, gap_work
        ADDX    gap_distances, gap_work, gap_kinds
        ADDX    gap_kinds, gap_work, gap_withins
        SHIFTI  gap_surfaces, 6, gap_row
        .endm
