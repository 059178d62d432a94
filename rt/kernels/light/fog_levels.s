; fog_levels.s - applies fogs to the rays when everything they spawned has been
; added to their colours: to a level's list before it is added to the previous
; level, and at the end to the pixels of the frame.
;
; fog_list: In: level, its list traced.  fog_frame: In: the frame's planes.
; fog_depths: In: the queue's nearest and nearest_primitive.  Out: its part of
; LIST_DEPTH. fog_list and fog_frame pass QUEUE rays at a time to fog_rays
; (routines_vector.s, fog_1984.s).

        .include "light/fog.s"

        .share  scratch
        .reg    fog_depth, r250         ; distances that the n rays see
        .endshare

        .data
fog_position:   .word 0
fog_link:       .word 0
        .align  64
fog_store:      .space QUEUE
        .code

; n := the number of the s1 rays left from fog_position on, at most QUEUE; s4 :=
; that position.  Branches to done if there are none.
        .macro  fog_queue done
        load_word fog_position, s4
        SUBX    s1, s4, s2
        IBXEQ   s2, r0, r0, \done
        at_most QUEUE, s2, n
        ADDX    s4, n, s3
        store_word s3, fog_position, shape_at
        SHIFTI  s4, 6, s4
        .endm

        .macro  fog_begin
        store_word link, fog_link, shape_at
        store_word r0, fog_position, shape_at
        .endm

        .macro  fog_return
        load_word fog_link, link
        BIM     0, link
        .endm

        .kernel resolve
fog_depths:
        list_vector level, LIST_DEPTH, s2
        LOD     [level, one_index], s4
        SHIFTI  s4, 6, s4
        ADDX    s2, s4, s2
        ADDLEN  s2, n, s2
        VTOV    [nearest], [s2]
        describe near_bits, queue_bits, n
        CMPEQV  [nearest_primitive], r0, [near_bits]
        load_word fog_far, s3
        VTOV    s3, [s2] ? [near_bits]
        BIM     0, link

fog_list:
        fog_begin
fog_list_next:
        LOD     [level], s1
        fog_queue fog_list_done
        EX      s3, 64 * LIST
        list_vector level, LIST_COLOR, s2
        ADDX    s2, s4, s2
        three_planes s2, s3, out_red, out_green, out_blue
        ADDX    out_blue, s3, fog_depth
        call_routine fog_rays, link_kernel
        BIM     fog_list_next
fog_list_done:
        fog_return

fog_frame:
        fog_begin
fog_frame_next:
        load_word scene_pixels, s1
        fog_queue fog_frame_done
        load_word scene_frame, s2
        load_word scene_pixels, s3
        SHIFTI  s3, 6, s3
        ADDX    s2, s4, s2
        three_planes s2, s3, out_red, out_green, out_blue
        ADDX    out_blue, s3, out_depth
        ES      s2, 4
        MPYX    s3, s2, s2
        ADDX    out_depth, s2, out_id
        describe fog_depth, fog_store, n
        VTOV    [out_depth], [fog_depth]
        describe near_bits, queue_bits, n
        CMPEQV  [out_id], r0, [near_bits]
        load_word fog_far, s3
        VTOV    s3, [fog_depth] ? [near_bits]
        call_routine fog_rays, link_kernel
        BIM     fog_frame_next
fog_frame_done:
        fog_return
        .endkernel
