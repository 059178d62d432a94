; crossed.s - lists of crossings with parallel rays, and sums over them.
;
; This is the common part of the programs that form such sums. Crossings are in
; the order of rays, and along a ray from near to far. The scalar form processes
; them one by one, the vector form LANES at a time.
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

        .include "points/planes.s"

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
        .regs   r20, col_at, col_half_lanes, col_lower, col_upper, at_col_upper
        .regs   r25, col_work0, col_work1, col_work2
        .regs   r32, col_s, col_normal, col_ray, col_part, col_sign, col_object_depth, col_scene_depth
        .regs   col_s, field0, field1, field2, field3, field4, field5, field6
        .regs   r39, col_w, col_lane, col_lanes_most
        .regs   r42, col_n, col_count, b_enter, b_leave, b_visible, b_part

        planes  col_lane, col_index_one, col_half_lanes, col_work1, b_part

        .macro  crossed_begin
        load_words crossed_arguments, CROSSED_ARGUMENTS, col_left, col_work0
        SHIFTI  col_left, 6, col_stride
        lanes_begin
        .endm

; Loads the next crossing, or branches to `none` if none is left. In the vector
; form it makes descriptors of the next crossings, up to LANES.
        .macro  crossed_next none
        IBXEQ   col_left, r0, r0, \none
        crossed_lanes
        RTOR    col_planes, col_work0
        .rept   CROSSED_SIZE
        crossed_plane field\+
        .endr
        .endm

; Folds the lanes of each sum into one and stores it.
        .macro  fold_lanes
fold_sum\@:
        ES      col_half_lanes, LANES / 2
fold_halve\@:
        plane   col_lanes, col_lower
        SHIFTI  col_half_lanes, 6, col_work0
        column  col_lanes, col_upper
        advance col_upper, col_work0
        each    fold_lane\@
        fetch   col_lanes, col_lower
        fetch   at_col_upper, col_upper
        plus    col_lower, col_upper, col_lower
        store   col_lower, col_lanes
        next    fold_lane\@
        SHIFTI  col_half_lanes, -1, col_half_lanes
        IBXNE   col_half_lanes, r0, r0, fold_halve\@
        LOD     [col_lanes], col_work0
        STO     [col_sums], col_work0
        IX      col_sums, 64
        IX      col_lanes, 64 * LANES
        IBXNE   col_totals, col_index_minus_one, r0, fold_sum\@, col_totals
        .endm

        .ifdef  SCALAR
        .macro  lanes_begin
        ES      col_lane, 0
        ES      col_lanes_most, LANES
        .endm

        .macro  crossed_lanes
        .endm

        .macro  crossed_plane a
        LOD     [col_work0], \a
        ADDX    col_work0, col_stride, col_work0
        .endm

        .macro  crossed_done again
        IX      col_planes, 64
        SUBX    col_left, col_index_one, col_left
        IBXNE   col_lane, col_index_one, col_lanes_most, \again, col_lane
        ES      col_lane, 0
        BIM     \again
        .endm

; Sets col_w to w, which is -1 where the ray enters by the count `bodies`.
; Branches to `invisible` if the ray neither enters nor leaves.
        .macro  find_weight bodies, invisible
        IBXEQ   col_sign, r0, r0, \invisible
        IBXNE   col_sign, r0, col_index_one, weight_leaves\@
        IBXNE   \bodies, r0, col_index_one, \invisible
        RTOR    col_minus_one, col_w
        BIM     weight_found\@
weight_leaves\@:
        IBXNE   \bodies, r0, r0, \invisible
        RTOR    col_one, col_w
weight_found\@:
        .endm

        .else
        .data
        .align  64
crossed_store:  .space LANES
crossed_bits:   .space LANES / 64 * 4 + 4
        .code

        .macro  lanes_begin
        .endm

        .macro  crossed_bit bits, number
        describe \bits, crossed_bits + LANES * (\number), col_n
        .endm

        .macro  crossed_lanes
        ES      col_n, LANES
        IBXLE   col_n, r0, col_left, crossed_full\@
        RTOR    col_left, col_n
crossed_full\@:
        describe col_w, crossed_store, col_n
        crossed_bit b_enter, 0
        crossed_bit b_leave, 1
        crossed_bit b_visible, 2
        crossed_bit b_part, 3
        .endm

        .macro  crossed_plane a
        ADDLEN  col_work0, col_n, \a
        ADDX    col_work0, col_stride, col_work0
        .endm

        .macro  crossed_done again
        advance_by col_planes, col_n, col_work0
        SUBX    col_left, col_n, col_left
        BIM     \again
        .endm

; Marks the crossings where the ray enters, where it leaves, and both, by the
; count `bodies`.
        .macro  find_visible bodies
        CMPEQV  [col_sign], col_index_one, [b_enter]
        keep_where CMPEQV, [\bodies], col_index_one, b_enter, b_part
        CMPEQV  [col_sign], col_index_minus_one, [b_leave]
        keep_where CMPEQV, [\bodies], r0, b_leave, b_part
        ORB     [b_enter], [b_leave], [b_visible]
        .endm

; [col_w] := w, which is -1 at crossings in [b_enter].
        .macro  find_weights
        VTOV    col_one, [col_w]
        VTOV    col_minus_one, [col_w] ? [b_enter]
        .endm

; The same for crossings at which the ray enters or leaves by the count
; `bodies`.
        .macro  find_weight bodies, invisible
        find_visible \bodies
        find_weights
        .endm
        .endif
