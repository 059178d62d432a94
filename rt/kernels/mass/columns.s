; columns.s - the volume, moments and area of solids from crossings with rays.
;
; The rays are parallel. A ray at p, q enters a part at s0 and leaves it at s1,
; and so on. The integrals over its column are differences of terms at the ends
; of the pieces. So each crossing adds, with w = -1 where the ray enters and 1
; where it leaves,
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

        .regs   r48, col_parts, col_rays, col_places, col_half, col_third
        .regs   r53, col_q_at           ; address of q
        .regs   r54, col_p, col_q, col_c
        .regs   r57, moment0, moment1, moment2, moment3, moment4, moment5, moment6, moment7, moment8, moment9, moment10

; Computes the terms of the crossing.
        .macro  find_moments
        times   col_w, col_s, moment0
        absolute col_normal, moment10
        times   moment0, col_p, moment1
        times   moment0, col_q, moment2
        times   moment0, col_s, col_c
        times   moment1, col_p, moment4
        times   moment2, col_q, moment5
        scale   col_c, col_half, moment3
        times   col_c, col_s, moment6
        times   moment1, col_q, moment7
        times   moment3, col_p, moment8
        times   moment3, col_q, moment9
        scale   moment6, col_third, moment6
        .endm

        .ifdef  SCALAR
        .macro  moments_begin
        .endm

; Adds the terms to the lane of the part with the number `part`.
        .macro  add_moments part
        ES      col_at, 64 * MOMENT_SIZE
        MPYX    \part, col_at, col_at
        EX      col_work0, LANES
        MPYX    col_at, col_work0, col_at
        ADDX    col_lanes, col_at, col_at
        .rept   MOMENT_SIZE
        LOD     [col_at, col_lane], col_work0
        ADDN    col_work0, moment\+, col_work0
        STO     [col_at, col_lane], col_work0
        IX      col_at, 64 * LANES
        .endr
        .endm

        .macro  add_to_part
        add_moments col_part
        .endm

        .macro  add_to_all
        add_moments col_parts
        .endm

        .else
        .reg    col_number, r68

        .data
        .align  64
column_store:   .space LANES * (MOMENT_SIZE + 3)
        .code

        .macro  column_vector vector, number
        describe \vector, column_store + 64 * LANES * (\number), col_n
        .endm

        .macro  moments_begin
        column_vector col_p, MOMENT_SIZE
        column_vector col_q, MOMENT_SIZE + 1
        column_vector col_c, MOMENT_SIZE + 2
        .rept   MOMENT_SIZE
        column_vector moment\+, \+
        .endr
        .endm

; Adds the terms of the crossings in [bits] to the lanes of the part at col_at,
; and advances col_at to the next part.
        .macro  add_moments bits
        .rept   MOMENT_SIZE
        ADDLEN  col_at, col_n, col_work0
        ADDNV   [col_work0], [moment\+], [col_work0] ? [\bits]
        IX      col_at, 64 * LANES
        .endr
        .endm

; Adds the terms to the lanes of each part that has a visible crossing.
        .macro  add_to_part
        RTOR    col_lanes, col_at
        ES      col_number, 0
part_next\@:
        CMPEQV  [col_part], col_number, [b_part]
        ANDB    [b_part], [b_visible], [b_part]
        CNTOB   [b_part], col_count
        IBXNE   col_count, r0, r0, part_add\@
        IX      col_at, 64 * LANES * MOMENT_SIZE
        BIM     part_added\@
part_add\@:
        add_moments b_part
part_added\@:
        IBXNE   col_number, col_index_one, col_parts, part_next\@, col_number
        .endm

        .macro  add_to_all
        add_moments b_visible
        .endm
        .endif

        .entry  columns
        .kernel columns
columns:
        crossed_begin
        load_words columns_arguments, COLUMNS_ARGUMENTS, col_parts, col_work0
        SHIFTI  col_rays, 6, col_q_at
        ADDX    col_places, col_q_at, col_q_at
columns_next:
        crossed_next columns_fold
        moments_begin
        gather  col_ray, col_places, col_p
        gather  col_ray, col_q_at, col_q
        find_weight col_object_depth, columns_within
        find_moments
        add_to_part
columns_within:
        find_weight col_scene_depth, columns_added
        find_moments
        add_to_all
columns_added:
        crossed_done columns_next

columns_fold:
        fold_lanes
        EXIT
        .endkernel
