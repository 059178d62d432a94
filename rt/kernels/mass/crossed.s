; crossed.s - lists of crossings with parallel rays, and sums over them.
;
; This is the common part of the programs that form such sums. Crossings are in
; the order of rays, and along a ray from near to far.
;
; Sums are formed in LANES lanes: crossing j is added to lane j mod LANES. At
; the end the upper half of the lanes is added to the lower half until one lane
; is left. So a sum depends only on its terms and their packets.
;
; An object may have overlapping bodies. A ray enters the object where `inside`
; rises from 0 to 1, and leaves it where `inside` falls to 0. `within` is the
; same count for the bodies of all objects.
;
; In:  the words below; sums of zeros.
; Source: derived here.

        .equ    LANES, 1024

; A crossing's words: consecutive planes.
        .record CROSSED
        .field  CROSSED_S               ; distance from the middle along the ray
        .field  CROSSED_NORMAL          ; component of the normal along the ray
        .field  CROSSED_RAY             ; number of the ray in its packet, an
                                        ; integer, like all words below
        .field  CROSSED_PART            ; number of the part, from 0
        .field  CROSSED_SIGN            ; 1: it enters a body, -1: it leaves one
        .field  CROSSED_OBJECT_DEPTH    ; number of the object's bodies that
                                        ; contain the ray after it
        .field  CROSSED_SCENE_DEPTH     ; the same for all objects
        .endrecord

        .data
crossed_arguments:
crossed_count:  .word 0                 ; number of crossings, an integer
crossed_planes: .word 0                 ; address of the planes of crossings
crossed_totals: .word 0                 ; number of sums, an integer
crossed_lanes:  .word 0                 ; address of LANES zeros for each sum
crossed_sums:   .word 0                 ; address of the sums
                .word 1, -1             ; col_index_one, col_index_minus_one
                .word 1.0, -1.0
                .equ    CROSSED_ARGUMENTS, 9
        .code

        .regs   r10, col_left, col_planes, col_totals, col_lanes, col_sums
        .regs   r15, col_index_one, col_index_minus_one, col_one, col_minus_one
        .regs   r19, col_stride         ; bits between planes
        .regs   r20, col_at, col_upper, col_half_lanes
        .regs   r23, col_work0, col_work1, col_work2

        .macro  crossed_begin
        EX      col_work0, crossed_arguments
        ELEN    col_work0, CROSSED_ARGUMENTS
        SWAP    [col_work0], col_left, [r0]
        SHIFTI  col_left, 6, col_stride
        .endm

; Stores the sum, whose lanes have been folded into one, and branches to `fold`
; while there is another sum.
        .macro  next_sum fold
        LOD     [col_lanes], col_work0
        STO     [col_sums], col_work0
        IX      col_sums, 64
        IX      col_lanes, 64 * LANES
        IBXNE   col_totals, col_index_minus_one, r0, \fold, col_totals
        .endm
