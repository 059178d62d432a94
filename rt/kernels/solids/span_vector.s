; span_vector.s - the span of each current ray in which a region can be visible.
;
; Some primitives of a tree are required: a ray outside one of them is outside
; the tree (N_NEEDED). So nothing is visible before a ray enters each of them,
; or after it leaves one. Surfaces nearer than delta count as one. So the span
; is
;
;   in - 2 delta < E < out + 2 delta
;
; Rays with an empty span are done. If few rays are left, they are compressed
; before the kernels of the other primitives are called.
;
; In:  the segments of the current rays in a primitive, segments_wanted of
;      them, in tin ..; leaf_needed.
; Out: last, near_limit; the current rays.
; Source: derived here.

; Events of the current rays (visible_vector.s).
        .share  scratch
        .regs   r233, event, last, event_primitive, before, after, active, visible_rays
        .reg    inside, r240            ; of one segment
        .endshare

; Makes descriptors of a value of the tree, before and after an event.
        .macro  value_of address, value, value_after
        ADDLEN  \address, near, \value
        address_of \value, QUEUE_BIT_WORDS, \value_after
        .endm

; The rays in object space.
        .regs   lox, local0, local1, local2, local3, local4, local5, local6, local7

        .data
event_bits:     .space 3 * QUEUE_BIT_WORDS
        .align  64
event_store:    .space 4 * QUEUE
last_store:     .space QUEUE
        .code

; [later] = the later of two ends of segments.
        .macro  later_end end, other, later
        CMPLTV  [\other], [\end], [bits0]
        MASKV   [\end], [\other], [\later] ? [bits0]
        .endm

        .kernel visible
begin_span:
        describe last, last_store, near
        VTOV    [wlower], [last]
        BIM     0, link_inner

node_hit:
        IBXEQ   leaf_needed, r0, r0, node_next
        load_word k_delta, s2
        ADDN    s2, s2, s2
        describe last, last_store, near
        SUBNV   [tin], s2, [w0]
        CMPLTV  [last], [w0], [bits0]
        VTOV    [w0], [last] ? [bits0]
        IBXEQ   segments_wanted, r0, one_index, node_limit
        later_end tout2, tout, w1
        RTOR    w1, tout
        ES      s0, 2
        IBXEQ   segments_wanted, r0, s0, node_limit
        later_end tout3, tout, w1
        .if     MAX_CROSSINGS > 6
        RTOR    w1, tout
        RTOR    tout3, s3
        ES      s0, -3
        ADDX    segments_wanted, s0, segments_wanted
node_later:
        IBXEQ   segments_wanted, r0, r0, node_limit
        EX      s0, 64 * CROSSING_SIZE * 2
        ADDX    s3, s0, s3
        later_end s3, tout, w1
        IBXNE   segments_wanted, minus_one_index, r0, node_later, segments_wanted
        .endif
node_limit:
        ADDNV   [tout], s2, [w0]
        CMPLTV  [w0], [near_limit], [bits0]
        describe s3, ray_index_store + 64 * QUEUE, near
        MASKV   [w0], [near_limit], [s3] ? [bits0]
        RTOR    s3, near_limit
        describe active, event_bits, near
        CMPLTV  [last], [near_limit], [active]
        if_none active, s9, walk_skip
        if_sparse  s9, near, node_compress
        BIM     node_next
node_compress:
        call_routine compress_span, link_kernel
        BIM     node_next

; Makes the s9 rays of active the only current rays.
compress_span:
        CPSV    [last], [last] ? [active]
        leave_only wdx, world_store, 3, active
        leave_only wdy, world_store, 4, active
        leave_only wdz, world_store, 5, active
        IBXEQ   from_one_point, r0, r0, compress_origins
        change_length wo, wo, s9, near, s3
        BIM     compress_spaces
compress_origins:
        leave_only wox, world_store, 0, active
        leave_only woy, world_store, 1, active
        leave_only woz, world_store, 2, active
compress_spaces:
        IBXEQ   space, r0, r0, compress_crossings
        .rept   8
        CPSV    [local\+], [local\+] ? [active]
        .endr
compress_crossings:
        load_leaves
        call_routine compress_rays, link_inner
        call_routine take_lower, link_inner
        BIM     0, link_kernel
        .endkernel
