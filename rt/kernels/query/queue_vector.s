; queue_vector.s - queues of lines, for the vector form and the kernels mode.
;
; It loads the lines of a queue and makes descriptors of its results:
;
;   lines:
;           begin_machine
;           begin_queues
;   lines_next:
;           begin_queue             ; the next queue
;           ..                      ; visible crossings along its lines
;           next_queue              ; to lines_next, until there is none

; In bits: the distance from the word of one field to that of the next, and from
; one crossing to the next.
        .regs   r201, line_stride, line_step
        .regs   r203, lines_left, lines_from    ; index of the queue's first
        .regs   r205, seen_first                ; first plane, of the queue
        .regs   r206, line_counts               ; counts of the queue's lines
        .regs   r207, line_behind

; Moves the origins [o] back by line_behind, into vectors of the queue.
        .macro  move_behind o, d, number
        LINKV
        MPYSV   [\d], line_behind, [w2]
        SUBNV   [\o], [w2], [w3]
        describe \o, queue_store + 64 * QUEUE * \number, n
        VTOV    [w3], [\o]
        .endm

        .macro  begin_machine
        EX      s0, constants
        ELEN    s0, CONSTANTS
        SWAP    [s0], one, [r0]
        begin_counting
        EX      s4, QUEUE
        describe iota, count_store, s4
        INTVLV  r0, one_index, [iota]
        describe s5, least_store, s4
        VTOV    tmin, [s5]
        ES      from_one_point, 0
        ES      shadows, 0
        .endm

        .macro  begin_queues
        load_word lines_count, lines_left
        load_word lines_behind, line_behind
        SHIFTI  lines_left, 6, line_stride
        ES      line_step, SEEN_SIZE
        MPYX    line_step, line_stride, line_step
        ES      lines_from, 0
        .endm

        .macro  begin_queue
        EX      n, QUEUE
        IBXLE   n, r0, lines_left, queue_full\@
        RTOR    lines_left, n
queue_full\@:
        EX      target, begin_lines
        BSAVE   link_kernel, [target]
        .endm

        .macro  next_queue
        ADDX    lines_from, n, lines_from
        SUBX    lines_left, n, lines_left
        IBXNE   lines_left, r0, r0, lines_next
        EXIT
        .endm

        .kernel lines
; Prepares the queue's rays and the descriptors of its crossings.
begin_lines:
        set_near n
        set_hits_of_queue
        load_word k_far, s0
        VTOV    s0, [nearest]
        VTOV    r0, [hit_s]
        VTOV    r0, [hit_t]
        SHIFTI  lines_from, 6, s4
        load_word lines_counts, s2
        ADDX    s2, s4, s2
        ADDLEN  s2, n, line_counts
        load_word lines_found, s2
        ADDX    s2, s4, s2
        ADDLEN  s2, n, seen_first
        load_word lines_rays, s2
        ADDX    s2, s4, s2
        three_planes s2, line_stride, aox, aoy, aoz
        ADDX    aoz, line_stride, s2
        three_planes s2, line_stride, s4, s5, s6
        EX      s2, queue_store + 64 * QUEUE * 3
        EX      s3, 64 * QUEUE
        three_planes s2, s3, adx, ady, adz
        VTOV    [s4], [adx]
        VTOV    [s5], [ady]
        VTOV    [s6], [adz]
        normalise adx, ady, adz, w2, w3
        CFPEQ   line_behind, r0, begin_made
        move_behind aox, adx, 0
        move_behind aoy, ady, 1
        move_behind aoz, adz, 2
begin_made:
        BIM     0, link_kernel
        .endkernel
