; received_vector.s - the sums of received.s, receiver by receiver.
;
; It compresses the weights of each receiver and sums them by halves.

        .regs   r30, v_receivers, v_weights, b_own, rec_receiver

        .data
received_bits:  .space 65536 / 64
        .code

        ADDLEN  rec_weights, rec_rays, v_weights
        ADDLEN  rec_list, rec_rays, v_receivers
        describe b_own, received_bits, rec_rays
        ES      rec_receiver, 0
received_next:
        CMPEQV  [v_receivers], rec_receiver, [b_own]
        CNTOB   [b_own], rec_count
        STO     [rec_counts], rec_count
        IBXEQ   rec_count, r0, r0, received_none
        ADDLEN  rec_buffer, rec_count, rec_at
        CPSV    [v_weights], [rec_at] ? [b_own]
        fold    rec_buffer, rec_count, rec_one, rec_at
        store_sum rec_buffer
received_none:
        IX      rec_sums, 64
        IX      rec_counts, 64
        IBXNE   rec_receiver, rec_one, rec_left, received_next, rec_receiver
        RTOR    rec_rays, rec_count
        ADDLEN  rec_buffer, rec_count, rec_at
        VTOV    [v_weights], [rec_at]
        fold    rec_buffer, rec_count, rec_one, rec_at
        store_sum rec_buffer
        EXIT
