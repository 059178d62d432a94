; levels_vector.s - the order in which levels of rays are traced.
;
; Each level has a list of rays. The rays of a list were spawned by rays of the
; list before. "Level" means a list here. There are more lists than levels of
; reflection (LIST_RAY_LEVEL) if light passes through objects. All lists are
; empty when a band begins: their memory is new, or they were emptied at the end
; of the previous band.
;
; Rays of the first level are generated from pixels. Rays of other levels are in
; the list of their level, to which the previous level appended them
; (spawn_vector.s). A level is traced queue by queue. A queue may spawn up to
; two rays for each of its own. If the list of the next level has no room for
; them, that level is traced first, to its end, and its list is emptied. When a
; level has no more rays, the next level is traced to its end. Then its colours
; are added to the rays that spawned them (add_children). The state of a level
; is therefore its position in its list, and no routine is reentered.
;
; In:  the scene; the frame.  Out: the frame's planes.
; Source: the paper: spawned rays go back to the queue and are intersected when
; it is full.

; The list of a level, in vectors.
        .equ    LIST, 4 * QUEUE
        .record LIST
        .field  LIST_RAY, 6             ; origin 3, direction 3
        .field  LIST_WEIGHT, 3          ; of the ray's colour
        .field  LIST_IMPORTANCE         ; of the ray for its pixel
        .if     INTERIORS
        .field  LIST_INSIDE             ; bodies that contain the ray
        .field  LIST_RAY_LEVEL          ; its level; straight rays keep it, so
                                        ; there are fewer levels than lists
        .field  LIST_PASSED             ; as in queue_passed
        .endif
        .if     HIDDEN
        .field  LIST_CLASS              ; IMAGE_RAYS or REFLECTED_RAYS
        .endif
        .field  LIST_KIND               ; 0 reflected, 1 refracted
        .field  LIST_PARENT             ; its parent's place in the list before
        .field  LIST_COLOR, 3
        .if     FOG
        .field  LIST_DEPTH              ; length of the ray, for fog
        .endif
        .endrecord

; A level, in words.
        .record LEVEL
        .field  LEVEL_COUNT             ; rays in its list
        .field  LEVEL_POSITION          ; rays that are traced
        .at     64
        .field  LEVEL_LIST, LIST_SIZE * LIST
        .endrecord

        .reg    next_level, r27         ; 0: there is none
        .reg    link_levels, r33

        .data
levels_last:    .word 0                 ; address of the last level
queue_importance: .word 0               ; descriptor: importance of the rays
        .if     INTERIORS
queue_inside:   .word 0                 ; descriptor: bodies that rays are in
queue_level:    .word 0                 ; descriptor: levels of the rays
        .endif
        .if     HIDDEN
queue_classes:  .word 0                 ; descriptor: classes of the rays
queue_class_sum: .word 0                ; the sum of the classes that occur
        .endif
        .align  64
importance_one: .space QUEUE            ; importance of the first level's rays
        .if     INTERIORS
inside_unknown: .space QUEUE
        .endif
        .if     HIDDEN
class_image:    .space QUEUE            ; class of the first level's rays
        .endif
        .code

; Computes the address of a vector of a level's list.
        .macro  list_vector level, vector, address
        address_of \level, LEVEL_LIST + (\vector) * LIST, \address
        .endm

; The same from the position in the list on, which is s4 bits after its start.
        .macro  list_part vector, address
        list_vector level, \vector, \address
        ADDX    \address, s4, \address
        .endm

        .kernel frame
trace_levels:
        RTOR    link, link_levels
        load_word scene_levels, level
        load_word scene_level_count, s2
        ADDX    s2, minus_one_index, s2
        EX      s3, 64 * LEVEL_SIZE
        MPYX    s2, s3, s2
        ADDX    level, s2, s2
        store_word s2, levels_last, s3
        load_word scene_pixels, s0
        STO     [level], s0
        STO     [level, one_index], r0

levels_next:
        LOD     [level], s1
        LOD     [level, one_index], position
        SUBX    s1, position, n
        EX      s2, QUEUE
        IBXLE   n, r0, s2, levels_short
        RTOR    s2, n
levels_short:
        load_word levels_last, s3
        ES      next_level, 0
        IBXEQ   level, r0, s3, levels_trace
        EX      s3, 64 * LEVEL_SIZE
        ADDX    level, s3, next_level
        LOD     [next_level], s4
        IBXEQ   s4, r0, r0, levels_trace
        IBXEQ   n, r0, r0, levels_down
        ADDX    n, n, s5
        ADDX    s4, s5, s5
        EX      s6, LIST
        IBXLE   s5, r0, s6, levels_trace
levels_down:
        RTOR    next_level, level
        BIM     levels_next
levels_trace:
        load_word scene_levels, s0
        IBXEQ   n, r0, r0, levels_up
        EX      target, first_queue
        IBXEQ   level, r0, s0, levels_queue
        EX      target, list_queue
levels_queue:
        BSAVE   link, [target]
        call_routine find_nearest, link
levels_found:
        .if     KEYS
        describe s0, depth_store, n
        VTOV    [s0], [nearest]
        .endif
        .if     FOG
        load_word scene_levels, s0
        IBXEQ   level, r0, s0, levels_shade
        call_routine fog_depths, link
levels_shade:
        .endif
        call_routine shade, link
        LOD     [level, one_index], position
        ADDX    position, n, position
        STO     [level, one_index], position
        BIM     levels_next
levels_up:
        IBXEQ   level, r0, s0, levels_done
        .if     FOG
        call_routine fog_list, link
        .endif
        call_routine add_children, link
        STO     [level], r0
        STO     [level, one_index], r0
        EX      s3, 64 * LEVEL_SIZE
        SUBX    level, s3, level
        BIM     levels_next
levels_done:
        .if     FOG
        call_routine fog_frame, link
        .endif
        BIM     0, link_levels

; Prepares the next queue: its rays, its hits, the destination of its colours.
first_queue:
        RTOR    link, link_walk
        set_hits_of_queue
        add_to_counter rays_primary, n
        load_word scene_frame, s2
        load_word scene_pixels, s3
        SHIFTI  s3, 6, s3
        SHIFTI  position, 6, s4
        load_word scene_tiles, s5
        IBXEQ   s5, r0, r0, first_in_rows
        describe s5, order_store, n
        ES      s4, 0
first_in_rows:
        store_word s5, queue_order, s6
        ADDX    s2, s4, s2
        three_planes s2, s3, out_red, out_green, out_blue
        ADDX    out_blue, s3, out_depth
        ADDX    out_depth, s3, out_nx
        ADDX    out_nx, s3, out_ny
        ADDX    out_ny, s3, out_nz
        ADDX    out_nz, s3, out_id
        EX      s3, 64 * QUEUE
        EX      s2, queue_store
        three_planes s2, s3, aox, aoy, aoz
        ADDX    aoz, s3, adx
        ADDX    adx, s3, ady
        ADDX    ady, s3, adz
        describe s2, importance_one, n
        store_word s2, queue_importance, s3
        .if     INTERIORS
        store_word s2, queue_level, s3
        store_word r0, queue_passed, s3
        describe s2, inside_unknown, n
        store_word s2, queue_inside, s3
        .endif
        .if     HIDDEN
        describe s2, class_image, n
        store_word s2, queue_classes, s3
        EX      s3, queue_class_sum
        ES      s2, IMAGE_RAYS
        STO     [s3], s2
        .endif
        ES      from_one_point, 1 - ORIGINS_DIFFER
        call_routine generate, link_kernel
        BIM     0, link_walk

list_queue:
        set_hits_of_queue
        store_word r0, queue_order, s5
        EX      s3, 64 * LIST
        SHIFTI  position, 6, s4
        list_part LIST_RAY, s2
        three_planes s2, s3, aox, aoy, aoz
        ADDX    aoz, s3, adx
        ADDX    adx, s3, ady
        ADDX    ady, s3, adz
        list_part LIST_IMPORTANCE, s2
        ADDLEN  s2, n, s2
        store_word s2, queue_importance, s5
        .if     INTERIORS
        ADDX    s2, s3, s2
        store_word s2, queue_inside, s5
        ADDX    s2, s3, s2
        store_word s2, queue_level, s5
        ADDX    s2, s3, s2
        describe s5, queue_bits, n
        CMPNEV  [s2], r0, [s5]
        CNTOB   [s5], s6
        store_word r0, queue_passed, s5
        IBXEQ   s6, r0, r0, list_passed_none
        STO     [s5], s2
list_passed_none:
        .endif
        .if     HIDDEN
        list_part LIST_CLASS, s2
        ADDLEN  s2, n, s2
        EX      s5, queue_classes
        STO     [s5], s2
        describe s5, queue_bits, n
        ES      s6, REFLECTED_RAYS
        CMPEQV  [s2], s6, [s5]
        CNTOB   [s5], s5
        IBXEQ   s5, r0, n, list_class_sum
        ES      s6, IMAGE_RAYS
        IBXEQ   s5, r0, r0, list_class_sum
        ES      s6, IMAGE_RAYS + REFLECTED_RAYS
list_class_sum:
        store_word s6, queue_class_sum, s5
        .endif
        list_part LIST_COLOR, s2
        three_planes s2, s3, out_red, out_green, out_blue
        ES      from_one_point, 0
        BIM     0, link
        .endkernel

        .if     FOG
        .include "light/fog_levels.s"
        .endif
