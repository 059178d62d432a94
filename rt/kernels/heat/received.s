; received.s - how much each receiver gets of what points radiate: counts of rays, and sums
; of their weights; what the two forms have in common.
;
;   count_r = how many i have receiver_i = r        sum_r = sum of their weight_i
;
; and of all of them together the sum.  The order of a sum is that of halves: of m weights,
; in the order of points, the last m / 2 are added to the first, till one is left; so it
; depends on the weights alone.
;
; In:  what stands below.
; Out: received_sums: the sum of each receiver, and that of all; received_counts.
; Source: derived here, from the project's notes on radiant heat.

        .data
received_given:
received_rays:  .word 0                 ; how many, 1 .. 65535, an integer
received_receivers: .word 0             ; .. receivers
received_weights: .word 0               ; address of the weights
received_list:  .word 0                 ; .. of each ray's receiver, an integer from 0 on
received_sums:  .word 0                 ; .. of one word more than receivers
received_counts: .word 0                ; .. of the counts, zeros
received_room:  .word 0                 ; .. of as many words as rays
received_places: .word 0                ; .. as receivers
                .word 1, -1
                .equ    RECEIVED_GIVEN, 10
        .code

        .regs   r10, rec_rays, rec_left, rec_weights, rec_list, rec_sums, rec_counts
        .regs   r16, rec_room, rec_places, rec_one, rec_minus_one
        .regs   r20, rec_count, rec_half, rec_at, rec_upper, rec_work

        .macro  received_begin
        EX      rec_work, received_given
        ELEN    rec_work, RECEIVED_GIVEN
        SWAP    [rec_work], rec_rays, [r0]
        .endm
