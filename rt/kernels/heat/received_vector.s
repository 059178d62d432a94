; received_vector.s - the sums of received.s, receiver by receiver.
;
; It compresses the weights of each receiver and sums them by halves.

        .regs   r30, v_receivers, v_weights, b_own, rec_receiver

        .data
received_bits:  .space 65536 / 64
        .code

; Replaces the first rec_count words of the room by their sum, and stores it as
; the next sum.
        .macro  fold_sums
        BIM     fold_whole\@
fold_halve\@:
        ADDX    rec_count, rec_one, rec_half
        SHIFTI  rec_half, -1, rec_half  ; words that remain
        SUBX    rec_count, rec_half, rec_count
        SHIFTI  rec_half, 6, rec_work
        ADDLEN  rec_buffer, rec_count, rec_at
        ADDX    rec_at, rec_work, rec_upper
        ADDNV   [rec_at], [rec_upper], [rec_at]
        RTOR    rec_half, rec_count
fold_whole\@:
        IBXNE   rec_count, r0, rec_one, fold_halve\@
        LOD     [rec_buffer], rec_work
        STO     [rec_sums], rec_work
        .endm

        .kernel received
received:
        received_begin
        ADDLEN  rec_weights, rec_rays, v_weights
        ADDLEN  rec_list, rec_rays, v_receivers
        EX      b_own, received_bits
        ADDLEN  b_own, rec_rays, b_own
        ES      rec_receiver, 0
received_next:
        CMPEQV  [v_receivers], rec_receiver, [b_own]
        CNTOB   [b_own], rec_count
        STO     [rec_counts], rec_count
        IBXEQ   rec_count, r0, r0, received_none
        ADDLEN  rec_buffer, rec_count, rec_at
        CPSV    [v_weights], [rec_at] ? [b_own]
        fold_sums
received_none:
        IX      rec_sums, 64
        IX      rec_counts, 64
        IBXNE   rec_receiver, rec_one, rec_left, received_next, rec_receiver
        RTOR    rec_rays, rec_count
        ADDLEN  rec_buffer, rec_count, rec_at
        VTOV    [v_weights], [rec_at]
        fold_sums
        EXIT
        .endkernel
