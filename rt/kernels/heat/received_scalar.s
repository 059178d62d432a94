; received_scalar.s - the sums of received.s, ray by ray.
;
; It counts the rays of each receiver, moves each weight after the others of its
; receiver, and sums by halves.

        .regs   r30, rec_ray, rec_receiver, rec_first

        ES      rec_ray, 0
received_count:
        LOD     [rec_list, rec_ray], rec_receiver
        LOD     [rec_counts, rec_receiver], rec_count
        ADDX    rec_count, rec_one, rec_count
        STO     [rec_counts, rec_receiver], rec_count
        IBXNE   rec_ray, rec_one, rec_rays, received_count, rec_ray

        ES      rec_at, 0               ; positions in the room
        ES      rec_receiver, 0
received_place:
        STO     [rec_places, rec_receiver], rec_at
        LOD     [rec_counts, rec_receiver], rec_count
        ADDX    rec_at, rec_count, rec_at
        IBXNE   rec_receiver, rec_one, rec_left, received_place, rec_receiver

        ES      rec_ray, 0
received_put:
        LOD     [rec_list, rec_ray], rec_receiver
        LOD     [rec_weights, rec_ray], rec_work
        LOD     [rec_places, rec_receiver], rec_at
        STO     [rec_buffer, rec_at], rec_work
        ADDX    rec_at, rec_one, rec_at
        STO     [rec_places, rec_receiver], rec_at
        IBXNE   rec_ray, rec_one, rec_rays, received_put, rec_ray

        RTOR    rec_buffer, rec_first
received_next:
        LOD     [rec_counts], rec_count
        IBXEQ   rec_count, r0, r0, received_none
        SHIFTI  rec_count, 6, rec_receiver
        fold    rec_first, rec_count, rec_one, rec_at
        store_sum rec_first
        ADDX    rec_first, rec_receiver, rec_first
received_none:
        IX      rec_sums, 64
        IX      rec_counts, 64
        IBXNE   rec_left, rec_minus_one, r0, received_next, rec_left
        RTOR    rec_weights, rec_first
        RTOR    rec_rays, rec_count
        fold    rec_first, rec_count, rec_one, rec_at
        store_sum rec_first
        EXIT
