; crossed.s - lists of crossings with parallel rays, and the sums that are formed of them:
; what the programs of such sums have in common.
;
; Crossings stand in the order of rays, and along a ray from near to far.
;
; The order of sums is that of LANES lanes: crossing j is added to the lane j mod LANES;
; in the end the upper half of the lanes is added to the lower one, till one is left.
; So sums depend on what is added and in which packet, and on nothing else.
;
; An object may have bodies that overlap.  A ray comes into it where `inside` rises from 0
; to 1, and leaves it where that falls to 0; `within` counts the bodies of all objects
; likewise.
;
; In:  what stands below; sums of zeros.
; Source: derived here.

        .equ    LANES, 1024

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
crossed_given:
crossed_count:  .word 0                 ; crossings, an integer
crossed_planes: .word 0                 ; address of the planes of crossings
crossed_totals: .word 0                 ; sums, an integer
crossed_lanes:  .word 0                 ; address of LANES words for each sum: zeros
crossed_sums:   .word 0                 ; .. of the sums
                .word 1, -1             ; col_index_one, col_index_minus_one
                .word 1.0, -1.0
                .equ    CROSSED_GIVEN, 9
        .code

        .regs   r10, col_left, col_planes, col_totals, col_lanes, col_sums
        .regs   r15, col_index_one, col_index_minus_one, col_one, col_minus_one
        .regs   r19, col_stride         ; from a plane of crossings to the next, in bits
        .regs   r20, col_at, col_upper, col_half_lanes
        .regs   r23, col_work0, col_work1, col_work2

        .macro  crossed_begin
        EX      col_work0, crossed_given
        ELEN    col_work0, CROSSED_GIVEN
        SWAP    [col_work0], col_left, [r0]
        SHIFTI  col_left, 6, col_stride
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
