; gaps_vector.s - the counts of gaps.s, surface by surface.
;
; For each surface it compresses the gaps that begin there, and counts those
; that end at each surface.

        .regs   r30, v_near, v_far, v_length, v_kind, v_next, v_scene_depth, v_from, v_to, v_row
        .regs   r39, b_gap, b_open, b_own, gap_left, gap_own, gap_zero

        .data
gap_bits:       .space 65536 / 64 * 2
        .code

        .macro  gap_bit bits, number, length
        describe \bits, gap_bits + 65536 * (\number), \length
        .endm

; Makes a descriptor of a vector in the room, of the given length.
        .macro  gap_vector vector, number, length
        RTOR    gap_buffer, \vector
        .rept   \number
        ADDX    \vector, gap_work, \vector
        .endr
        ADDLEN  \vector, \length, \vector
        .endm

; Makes descriptors of a plane of ends from its first and from its second word.
        .macro  gap_plane plane, near, far
        ADDLEN  \plane, gap_count, \near
        address_of \near, 1, \far
        .endm

; Sets [b_gap] to the gaps that are empty and long enough.
        .macro  find_gaps
        gap_bit b_gap, 0, gap_count
        gap_bit b_open, 1, gap_count
        gap_vector v_length, 0, gap_count
        SUBNV   [v_far], [v_near], [v_length]
        ABSV    [v_length], [v_length]
        CMPGEV  [v_length], gap_least, [b_gap]
        keep_where CMPEQV, [v_scene_depth], gap_zero, b_gap, b_open
        .endm

        ES      gap_zero, 0
        SHIFTI  gap_count, 6, gap_work
        gap_plane gap_distances, v_near, v_far
        gap_plane gap_kinds, v_kind, v_next
        ADDLEN  gap_scene_depths, gap_count, v_scene_depth
        find_gaps
        if_none b_gap, gap_left, gaps_counted
        gap_vector v_from, 0, gap_left
        gap_vector v_to, 1, gap_left
        CPSV    [v_kind], [v_from] ? [b_gap]
        CPSV    [v_next], [v_to] ? [b_gap]
        gap_bit b_gap, 0, gap_left
        ES      gap_from, 0
gaps_from:
        CMPEQV  [v_from], gap_from, [b_gap]
        if_none b_gap, gap_own, gaps_done
        gap_vector v_row, 2, gap_own
        CPSV    [v_to], [v_row] ? [b_gap]
        gap_bit b_own, 1, gap_own
        ES      gap_to, 0
gaps_to:
        CMPEQV  [v_row], gap_to, [b_own]
        CNTOB   [b_own], gap_left
        STO     [gap_counts, gap_to], gap_left
        IBXNE   gap_to, gap_one, gap_surfaces, gaps_to, gap_to
gaps_done:
        ADDX    gap_counts, gap_row, gap_counts
        IBXNE   gap_from, gap_one, gap_surfaces, gaps_from, gap_from
gaps_counted:
        EXIT
