; sort_vector.s - sorts the crossings of a queue's rays by distance.
;
; At equal distances the lower primitive number is first. Column k has the k-th
; crossing of each ray, found in any order. A ray with fewer crossings has
; misses there, farther away than those in the columns before. A step puts two
; columns in order for all rays at once: elements in the wrong order are
; exchanged, with all their fields. The sequence of column pairs does not depend
; on the data. It is a sorting network, Batcher's merge exchange, for any number
; N of columns. With 2^t >= N, p is halved from 2^(t-1) to 1. For each p:
;
;   d = p, r = 0;  q is halved from 2^(t-1) to p; after the first q,
;   d = 2 q - p, r = p;  columns i and i + d are compared for each i < N - d
;   whose bit p equals that of r
;
; In:  query_counts_at, ray_hits_first, n.  Out: the planes of the queue.
; Source: Knuth, The Art of Computer Programming 3, 5.2.2, algorithm M.

        .regs   r213, sort_count, sort_top, sort_p, sort_q, sort_r, sort_d
        .regs   r219, sort_end, sort_index, sort_low, sort_high

        .data
        .align  64
sort_store:     .space 3 * QUEUE
        .code

        .kernel lines
sort_crossings:
        MAXV    [query_counts_at], s0, sort_count
        IBXLE   sort_count, r0, one_index, sort_done
        set_near n
        RTOR    ray_hits_first, sort_low
        ES      sort_index, 0
        RTOR    big, s2
sort_fill:
        CMPGEV  sort_index, [query_counts_at], [bits0]
        VTOV    s2, [sort_low] ? [bits0]
        ADDN    s2, big, s2
        ADDX    sort_low, query_step, sort_low
        IBXNE   sort_index, one_index, sort_count, sort_fill, sort_index
        ES      sort_top, 1
sort_double:
        ADDX    sort_top, sort_top, s0
        IBXGE   s0, r0, sort_count, sort_begin
        RTOR    s0, sort_top
        BIM     sort_double
sort_begin:
        RTOR    sort_top, sort_p
sort_pass:
        RTOR    sort_top, sort_q
        ES      sort_r, 0
        RTOR    sort_p, sort_d
sort_merge:
        SUBX    sort_count, sort_d, sort_end
        ES      sort_index, 0
        RTOR    ray_hits_first, sort_low
        MPYX    sort_d, query_step, sort_high
        ADDX    sort_low, sort_high, sort_high
sort_pair:
        AND     sort_index, sort_p, s0
        IBXNE   s0, r0, sort_r, sort_next
        CMPLTV  [sort_high], [sort_low], [bits0]
        CMPEQV  [sort_high], [sort_low], [bits1]
        if_none bits1, s0, sort_compared
        ADDX    sort_low, query_stride, s2
        ADDX    sort_high, query_stride, s3
        keep_where CMPLTV, [s3], [s2], bits1, bits2
        ORB     [bits0], [bits1], [bits0]
sort_compared:
        if_none bits0, s0, sort_next
        RTOR    sort_low, s2
        RTOR    sort_high, s3
        ES      s4, RAY_HIT_WORDS
        if_gather_pays s0, n, s5, sort_sparse
sort_exchange:
        VTOV    [s2], [w0]
        VTOV    [s3], [s2] ? [bits0]
        VTOV    [w0], [s3] ? [bits0]
        ADDX    s2, query_stride, s2
        ADDX    s3, query_stride, s3
        IBXNE   s4, minus_one_index, r0, sort_exchange, s4
        BIM     sort_next

; Gathers the elements if only few are exchanged.
sort_sparse:
        describe s6, count_store, n
        EX      s5, sort_store
        CPSV    [s6], [s5] ? [bits0]
        describe s6, sort_store + 64 * QUEUE, s0
        describe s7, sort_store + 64 * QUEUE * 2, s0
sort_gather:
        VXTOV   [s5], [s2], [s6]
        VXTOV   [s5], [s3], [s7]
        VTOVX   [s5], [s6], [s3]
        VTOVX   [s5], [s7], [s2]
        ADDX    s2, query_stride, s2
        ADDX    s3, query_stride, s3
        IBXNE   s4, minus_one_index, r0, sort_gather, s4
sort_next:
        ADDX    sort_low, query_step, sort_low
        ADDX    sort_high, query_step, sort_high
        IBXNE   sort_index, one_index, sort_end, sort_pair, sort_index
        IBXEQ   sort_q, r0, sort_p, sort_narrow
        SUBX    sort_q, sort_p, sort_d
        SHIFTI  sort_q, -1, sort_q
        RTOR    sort_p, sort_r
        BIM     sort_merge
sort_narrow:
        SHIFTI  sort_p, -1, sort_p
        IBXNE   sort_p, r0, r0, sort_pass
sort_done:
        BIM     0, link_kernel
        .endkernel
