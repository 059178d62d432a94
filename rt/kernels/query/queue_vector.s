; queue_vector.s - the main program of ray queries in queues, for the vector
; form and the kernels mode.
;
; The including program defines two macros: begin_form prepares its routines,
; and order_crossings orders the crossings that walk_regions found.

        .include "frame/records.s"
        .include "frame/queue.s"
        .include "query/query.s"
        .reg    link_walk, r133

; In bits: the distance from the word of one field to that of the next, and from
; one crossing to the next.
        .regs   r201, query_stride, query_step
        .regs   r203, query_left, query_from    ; index of the queue's first
        .regs   r205, ray_hits_first            ; first plane, of the queue
        .regs   r206, query_counts_at           ; counts of the queue's rays
        .regs   r207, query_start_distance

; Moves the origins [o] back by query_start_distance, into vectors of the queue.
        .macro  move_behind o, d, number
        LINKV
        MPYSV   [\d], query_start_distance, [w2]
        SUBNV   [\o], [w2], [w3]
        describe \o, queue_store + 64 * QUEUE * \number, n
        VTOV    [w3], [\o]
        .endm

        .kernel lines
lines:
        load_words constants, CONSTANTS, one, shape_at
        begin_counting
        EX      s4, QUEUE
        describe iota, count_store, s4
        INTVLV  r0, one_index, [iota]
        describe s5, least_store, s4
        VTOV    tmin, [s5]
        ES      from_one_point, 0
        ES      shadows, 0
        begin_form
        load_word query_count, query_left
        load_word query_start, query_start_distance
        SHIFTI  query_left, 6, query_stride
        ES      query_step, RAY_HIT_SIZE
        MPYX    query_step, query_stride, query_step
        ES      query_from, 0
query_next:
        at_most QUEUE, query_left, n
        call_routine begin_query, link_kernel
        call_routine walk_regions, link
        order_crossings
        .if     DEPTHS
        call_routine count_depths, link_kernel
        .endif
        ADDX    query_from, n, query_from
        SUBX    query_left, n, query_left
        IBXNE   query_left, r0, r0, query_next
        EXIT

; Prepares the queue's rays and the descriptors of its crossings.
begin_query:
        set_near n
        set_hits_of_queue
        load_word k_far, s0
        VTOV    s0, [nearest]
        VTOV    r0, [hit_s]
        VTOV    r0, [hit_t]
        SHIFTI  query_from, 6, s4
        load_word query_counts, s2
        ADDX    s2, s4, s2
        ADDLEN  s2, n, query_counts_at
        load_word query_hits, s2
        ADDX    s2, s4, s2
        ADDLEN  s2, n, ray_hits_first
        load_word query_rays, s2
        ADDX    s2, s4, s2
        three_planes s2, query_stride, aox, aoy, aoz
        ADDX    aoz, query_stride, s2
        three_planes s2, query_stride, s4, s5, s6
        EX      s2, queue_store + 64 * QUEUE * 3
        EX      s3, 64 * QUEUE
        three_planes s2, s3, adx, ady, adz
        copy_three [s4], [s5], [s6], [adx], [ady], [adz], VTOV
        normalise adx, ady, adz, w2, w3
        CFPEQ   query_start_distance, r0, begin_query_done
        three   move_behind, aox, aoy, aoz, adx, ady, adz, 0, 1, 2
begin_query_done:
        BIM     0, link_kernel
        .endkernel
