; columns.s - what a solid's crossings with parallel rays add to its volume, moments and
; area; what the two forms have in common.
;
; A ray at p, q comes into a part at s0 and leaves it at s1, and so on.  In the integrals
; over its column all pieces stand as differences of what belongs to their ends, so
; each crossing adds, with w = -1 where the ray comes in and 1 where it leaves,
;
;   a = w s                 b = a s / 2             c = a s s / 3
;   MOMENT_1:  a            MOMENT_P:  a p          MOMENT_Q:  a q      MOMENT_S:  b
;   MOMENT_PP: a p p        MOMENT_QQ: a q q        MOMENT_SS: c
;   MOMENT_PQ: a p q        MOMENT_PS: b p          MOMENT_QS: b q
;   MOMENT_AREA: |n|                                n: the normal along the ray
;
; for the volume, its moments with p, q, s, and the part of its surface: over all three
; views, of which n are the components of one normal, n^2 adds up to one, so that
; each surface element is counted by its area, in bounded pieces.
;
; After the parts themselves all of them together are added up by `within`: what overlaps
; counts once.
;
; In:  what stands in crossed.s and below.
; Out: crossed_sums, for each part, and all together, MOMENT_SIZE sums behind each other.
; Source: derived here, from the project's notes on heat and mass properties; the
; divergence theorem.

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
columns_given:
column_parts:   .word 0                 ; parts, an integer
column_rays:    .word 0                 ; .. rays
column_places:  .word 0                 ; address of p and q, two planes of column_rays words
                .word 0.5, 0.333333333333333333
                .equ    COLUMNS_GIVEN, 5
        .code

        .regs   r26, col_parts, col_rays, col_places, col_half, col_third
        .regs   r31, col_q_at           ; of the second plane of places

        .macro  columns_begin
        crossed_begin
        EX      col_work0, columns_given
        ELEN    col_work0, COLUMNS_GIVEN
        SWAP    [col_work0], col_parts, [r0]
        SHIFTI  col_rays, 6, col_q_at
        ADDX    col_places, col_q_at, col_q_at
        .endm
