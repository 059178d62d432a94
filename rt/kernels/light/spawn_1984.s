; spawn_1984.s - appends the rays spawned by the hits to the next level's list,
; hit by hit; reflected before refracted.  This routine is a part of the loops
; that shade and is called by loop_link.

        .share  local
        .regs   r32, list_at, list_place, list_stride, list_index, is_mirror
        .regs   r37, is_clear, hit_weight_at
        .regs   r39, is_reflected, is_refracted, parent
        .regs   r42, child_ox, child_oy, child_oz, child_dx, child_dy, child_dz
        .regs   r48, child_least, child_scaled
        .if     INTERIORS
        .regs   r50, child_passed, child_inside, child_level
        .regs   r53, child_weight, child_red, child_green, child_blue
        .regs   r57, ray_inside_at, ray_level_at
        .regs   r59, ray_inside, ray_level, ray_weight
        .else
        .regs   r50, child_weight, child_red, child_green, child_blue
        .endif
        .if     HIDDEN
        .regs   r62, child_class, ray_class_at
        .endif
        .endshare

        .data
spawn_list:     .space 3
                .word 0
                .descriptor 2, spawn_followed
                .descriptor CHILD_SIZE, spawn_children
                .descriptor CHILD_SIZE, spawn_children + 64 * CHILD_SIZE
                .if     GLOSS
                .word 0
                .endif
spawn_followed: .space 2
        .if     INTERIORS
spawn_state:    .space SPAWN_STATE
        .endif
spawn_children: .space 2 * CHILD_SIZE
        .code

        .macro  spawn_argument number, offset, words
        address_of hit_at, \offset, loop_work
        ELEN    loop_work, \words
        store_word loop_work, spawn_list + 64 * \number
        .endm

; Appends a child of spawn_children to the list, with its kind.
        .macro  append child, kind, counter
        load_words spawn_children + 64 * CHILD_SIZE * \child, CHILD_SIZE, child_ox
        LOD     [of_next], list_index
        SHIFTI  list_index, 6, list_place
        ADDX    list_at, list_place, list_place
        store_step child_ox, list_place, list_stride
        store_step child_oy, list_place, list_stride
        store_step child_oz, list_place, list_stride
        store_step child_dx, list_place, list_stride
        store_step child_dy, list_place, list_stride
        store_step child_dz, list_place, list_stride
        store_step child_red, list_place, list_stride
        store_step child_green, list_place, list_stride
        store_step child_blue, list_place, list_stride
        store_step child_weight, list_place, list_stride
        .if     INTERIORS
        store_step child_inside, list_place, list_stride
        store_step child_level, list_place, list_stride
        store_step child_passed, list_place, list_stride
        .endif
        .if     HIDDEN
        store_step child_class, list_place, list_stride
        .endif
        store_step \kind, list_place, list_stride
        store_step parent, list_place, list_stride
        IX      list_index, 1
        STO     [of_next], list_index
        EX      loop_at, \counter
        LOD     [loop_at], loop_work
        IS      loop_work, 1
        STO     [loop_at], loop_work
        .endm

        .kernel spawn
spawn_hits:
        begin_hits
        IBXEQ   of_next, r0, r0, spawn_end
        address_of of_next, LEVEL_LIST, list_at
        EX      list_stride, 64 * LIST
        load_word queue_importance, hit_weight_at
        .if     INTERIORS
        load_word queue_inside, ray_inside_at
        load_word queue_level, ray_level_at
        .endif
        .if     HIDDEN
        load_word queue_classes, ray_class_at
        .endif
        load_order
spawn_hit:
        load_part hit_at, HIT_PRIMITIVE, 2, new_primitive ; also its index
        address_of new_primitive, P_MIRROR, loop_at
        LOD     [loop_at], is_mirror
        LOD     [loop_at, m_index_one], is_clear
        OR      is_mirror, is_clear, is_clear
        IBXEQ   is_clear, r0, r0, spawn_next
        spawn_argument 0, HIT_RAY, 6
        EX      loop_at, spawn_list
        STO     [loop_at, m_index_one], new_primitive
        spawn_argument 2, HIT_SAMPLE + SAMPLE_NORMAL, SAMPLE_SIZE - SAMPLE_NORMAL
        .if     GLOSS
        spawn_argument 7, HIT_PIGMENT, 3
        .endif
        .if     INTERIORS
        LOD     [ray_inside_at, new_index], ray_inside
        LOD     [ray_level_at, new_index], ray_level
        LOD     [hit_weight_at, new_index], ray_weight
        EX      loop_work, spawn_state
        store_to ray_inside, SPAWN_STATE, loop_work
        .else
        SHIFTI  new_index, 6, loop_work
        ADDX    hit_weight_at, loop_work, loop_work
        .endif
        store_word loop_work, spawn_list + 64 * 3
        call    spawn, spawn_list
        ADDX    new_index, of_position, parent
        IBXEQ   of_order, r0, r0, spawn_in_rows
        LOD     [of_order, new_index], parent
spawn_in_rows:
        load_words spawn_followed, 2, is_reflected
        .if     HIDDEN
        ES      child_class, REFLECTED_RAYS
        .endif
        IBXEQ   is_reflected, r0, r0, spawn_not_reflected
        append  0, r0, rays_reflected
spawn_not_reflected:
        IBXEQ   is_refracted, r0, r0, spawn_next
        .if     HIDDEN
        IBXEQ   is_refracted, r0, child_class, spawn_class_found ; 2: total
        LOD     [ray_class_at, new_index], child_class
spawn_class_found:
        .endif
        append  1, m_index_one, rays_refracted
spawn_next:
        next_hit spawn_hit
spawn_end:
        BIM     0, loop_link
        .endkernel
