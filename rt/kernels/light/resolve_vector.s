; resolve_vector.s - adds the colours of a level's rays to their parents in the
; previous level.
;
;   parent's colour := parent's colour + weight * colour
;
; Reflected rays are added before refracted ones, queue by queue of the level's
; list, so that no parent occurs twice in one scatter.
;
; In:  level, its list traced.  Out: the colours of the previous level.
; Source: the project's own; the order makes the sums equal in all forms.

; Descriptors.
        .share  scratch
        .regs   r233, child_kind, child_parent, child_weight, child_color
        .regs   r237, parent_color, of_kind, chosen_parent, chosen_weight
        .regs   r241, chosen_color, children, children_left, child_stride
        .regs   r245, parent_stride, channels_left, wanted_kind, child_count
        .reg    child_list, r249
        .endshare

        .data
child_bits:     .space QUEUE_BIT_WORDS
        .align 64
child_store:    .space 3 * QUEUE
        .code

        .kernel resolve
        .macro  choose_child vector, into, number
        EX      \into, child_store + 64 * QUEUE * \number
        CPSV    [\vector], [\into] ? [of_kind]
        .endm

add_children:
        LOD     [level], children_left
        EX      child_stride, 64 * LIST
        list_vector level, LIST_KIND, child_list
add_queue:
        RTOR    children_left, children
        EX      s2, QUEUE
        IBXLE   children, r0, s2, add_short
        RTOR    s2, children
add_short:
        ADDLEN  child_list, children, child_kind
        ADDX    child_kind, child_stride, child_parent
        describe of_kind, child_bits, children
        ES      wanted_kind, 0
add_kind:
        CMPEQV  [child_kind], wanted_kind, [of_kind]
        if_none of_kind, s0, add_kind_done
        SUBX    s0, children, child_count
        RTOR    child_parent, chosen_parent
        IBXEQ   child_count, r0, r0, add_parents
        choose_child child_parent, chosen_parent, 0
add_parents:
        RTOR    child_kind, child_weight
        RTOR    child_parent, child_color
        ES      s2, LIST_WEIGHT - LIST_KIND
        MPYX    child_stride, s2, s2
        ADDX    child_weight, s2, child_weight
        ADDX    child_color, child_stride, child_color
        EX      s3, 64 * LEVEL_SIZE
        SUBX    level, s3, s3
        list_vector s3, LIST_COLOR, parent_color
        RTOR    child_stride, parent_stride
        load_word scene_levels, s4
        IBXNE   s3, r0, s4, add_channels
        load_word scene_frame, parent_color
        load_word scene_pixels, parent_stride
        SHIFTI  parent_stride, 6, parent_stride
add_channels:
        ES      channels_left, 3
add_channel:
        RTOR    child_weight, chosen_weight
        RTOR    child_color, chosen_color
        IBXEQ   child_count, r0, r0, add_weighted
        choose_child child_weight, chosen_weight, 1
        choose_child child_color, chosen_color, 2
add_weighted:
        LTOR    chosen_parent, s2
        describe s3, child_store + 64 * QUEUE, s2
        describe s4, child_store + 64 * QUEUE * 2, s2
        MPYSV   [chosen_weight], [chosen_color], [s3]
        VXTOV   [chosen_parent], [parent_color], [s4]
        ADDNV   [s4], [s3], [s4]
        VTOVX   [chosen_parent], [s4], [parent_color]
        ADDX    child_weight, child_stride, child_weight
        ADDX    child_color, child_stride, child_color
        ADDX    parent_color, parent_stride, parent_color
        IBXNE   channels_left, minus_one_index, r0, add_channel, channels_left
add_kind_done:
        IBXEQ   wanted_kind, r0, one_index, add_queue_done
        ES      wanted_kind, 1
        BIM     add_kind
add_queue_done:
        SUBX    children_left, children, children_left
        advance_by child_list, children, s2
        IBXNE   children_left, r0, r0, add_queue
        BIM     0, link
        .endkernel
