; columns.s - the volume, moments and area of solids from crossings with rays.
;
; This is the common part of the two forms. The rays are parallel. A ray at p, q
; enters a part at s0 and leaves it at s1, and so on. The integrals over its
; column are differences of terms at the ends of the pieces. So each crossing
; adds, with w = -1 where the ray enters and 1 where it leaves,
;
;   a = w s                 b = a s / 2             c = a s s / 3
;   MOMENT_1:  a            MOMENT_P:  a p          MOMENT_Q:  a q
;   MOMENT_S:  b            MOMENT_PP: a p p        MOMENT_QQ: a q q
;   MOMENT_SS: c            MOMENT_PQ: a p q        MOMENT_PS: b p
;   MOMENT_QS: b q          MOMENT_AREA: |n|
;
; to the volume, to its moments with p, q, s, and to the area of the surface. n
; is the component of the normal along the ray. The three views have the three
; components of one normal, whose squares n^2 sum to one. So each surface
; element is counted by its area, in bounded terms.
;
; After the sums of the parts come the sums of all parts together, by `within`:
; overlaps count once.
;
; In:  the words of crossed.s and below.
; Out: crossed_sums, for each part, then for all together, MOMENT_SIZE sums.
; Source: derived here, from the project's notes on heat and mass properties;
; the divergence theorem.

        .include "points/planes.s"
        .include "mass/crossed.s"

        .record MOMENT
        .field  MOMENT_1
        .field  MOMENT_P
        .field  MOMENT_Q
        .field  MOMENT_S
        .field  MOMENT_PP
        .field  MOMENT_QQ
        .field  MOMENT_SS
        .field  MOMENT_PQ
        .field  MOMENT_PS
        .field  MOMENT_QS
        .field  MOMENT_AREA
        .endrecord

        .data
columns_arguments:
column_parts:   .word 0                 ; number of parts, an integer
column_rays:    .word 0                 ; number of rays, an integer
column_places:  .word 0                 ; address of p and q, two planes of
                                        ; column_rays words
                .word 0.5, 0.333333333333333333
                .equ    COLUMNS_ARGUMENTS, 5
        .code

        .regs   r26, col_parts, col_rays, col_places, col_half, col_third
        .regs   r31, col_q_at           ; address of q

        .macro  columns_begin
        crossed_begin
        EX      col_work0, columns_arguments
        ELEN    col_work0, COLUMNS_ARGUMENTS
        SWAP    [col_work0], col_parts, [r0]
        SHIFTI  col_rays, 6, col_q_at
        ADDX    col_places, col_q_at, col_q_at
        .endm

        .entry  columns
        by_hand mass/columns
