; received.s - sums up the radiation that each receiver gets.
;
; It counts the rays of each receiver and adds their weights:
;
;   count_r = number of i with receiver_i = r      sum_r = sum of their weight_i
;
; It also computes the sum of all weights. A sum is formed by halves (fold.s),
; in the order of points.
;
; In:  the words below.
; Out: received_sums: the sum of each receiver, then that of all;
;      received_counts.
; Source: derived here, from the project's notes on radiant heat.

        .include "points/planes.s"
        .include "heat/fold.s"

        .data
received_arguments:
received_rays:  .word 0                 ; number of rays, 1 .. 65535, an integer
received_receivers: .word 0             ; number of receivers, an integer
received_weights: .word 0               ; address of the weights
received_list:  .word 0                 ; address of each ray's receiver, from 0
received_sums:  .word 0                 ; address of the sums, then the total
received_counts: .word 0                ; address of the counts, zeros
received_buffer: .word 0                ; address of a word for each ray
received_places: .word 0                ; address of a word for each receiver
                .word 1, -1
                .equ    RECEIVED_ARGUMENTS, 10
        .code

        .regs   r10, rec_rays, rec_left, rec_weights, rec_list, rec_sums, rec_counts
        .regs   r16, rec_buffer, rec_places, rec_one, rec_minus_one
        .regs   r20, rec_count, rec_at, rec_work

; Stores the word at the address as the next sum.
        .macro  store_sum address
        LOD     [\address], rec_work
        STO     [rec_sums], rec_work
        .endm

        .entry  received
        .kernel received
received:
        load_words received_arguments, RECEIVED_ARGUMENTS, rec_rays, rec_work
        by_hand heat/received
        .endkernel
