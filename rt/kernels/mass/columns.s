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
; An object may have bodies that overlap.  A ray comes into it where `inside` rises from 0
; to 1, and leaves it where that falls to 0.  After the parts themselves all of them
; together are added up by `within` likewise, which counts the bodies of all: what
; overlaps counts once.
;
; The order of sums is that of LANES lanes: crossing j, in the order of rays and along
; them, is added to the lane j mod LANES; in the end the upper half of the lanes is
; added to the lower one, till one is left.  So figures depend on what is added and in
; which packet, and on nothing else.
;
; In:  what stands below; sums of zeros.
; Out: column_sums, for each part, and all together, MOMENT_SIZE sums behind each other.
; Source: derived here, from the project's notes on heat and mass properties; the
; divergence theorem.

        .equ    LANES, 1024

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

; A crossing's words: planes, one behind the other.
        .record CROSSED
        .field  CROSSED_S               ; the distance from the middle along the ray
        .field  CROSSED_NORMAL          ; its component along the ray
        .field  CROSSED_RAY             ; the ray's number in its packet, an integer;
                                        ; as all below
        .field  CROSSED_PART            ; from 0 on
        .field  CROSSED_SENSE           ; 1: the ray comes into a body, -1: it leaves one
        .field  CROSSED_INSIDE          ; in how many of the object it is then
        .field  CROSSED_WITHIN          ; .. of all objects
        .endrecord

        .data
columns_given:
column_count:   .word 0                 ; crossings, an integer
column_parts:   .word 0                 ; parts, an integer
column_planes:  .word 0                 ; address of the planes of crossings
column_places:  .word 0                 ; .. of p and q, two planes of column_rays words
column_rays:    .word 0                 ; an integer
column_lanes:   .word 0                 ; address of LANES words for each sum: zeros
column_sums:    .word 0                 ; .. of the sums
                .word 1, -1             ; index_one, index_minus_one
                .word 1.0, -1.0, 0.5, 0.333333333333333333
                .equ    COLUMNS_GIVEN, 13
        .code

        .regs   r10, col_left, col_parts, col_planes, col_places, col_rays, col_lanes, col_sums
        .regs   r17, col_index_one, col_index_minus_one
        .regs   r19, col_one, col_minus_one, col_half, col_third
        .regs   r23, col_stride         ; from a plane of crossings to the next, in bits
        .regs   r24, col_q_at           ; of the second plane of places
        .regs   r25, col_work0, col_work1, col_work2
        .regs   r28, col_totals         ; sums that there are
        .regs   r29, col_half_lanes

        .macro  columns_begin
        EX      col_work0, columns_given
        ELEN    col_work0, COLUMNS_GIVEN
        SWAP    [col_work0], col_left, [r0]
        SHIFTI  col_left, 6, col_stride
        SHIFTI  col_rays, 6, col_q_at
        ADDX    col_places, col_q_at, col_q_at
        ADDX    col_parts, col_index_one, col_totals
        ES      col_work0, MOMENT_SIZE
        MPYX    col_totals, col_work0, col_totals
        .endm

; Where the lanes of a sum have become one: it goes to its place, and while there are
; more the next one is folded.
        .macro  next_sum fold
        LOD     [col_lanes], col_work0
        STO     [col_sums], col_work0
        IX      col_sums, 64
        IX      col_lanes, 64 * LANES
        IBXNE   col_totals, col_index_minus_one, r0, \fold, col_totals
        .endm
