; seen_vector.s - scatters the visible crossings of a queue to their planes.
;
; The next crossing of a line with k crossings goes to column k, so no line
; occurs twice in one scatter.
;
; found_crossings: In: the crossings of the rays of [seen] at [event], on
;                  event_met; the values of the region's tree after them.
;                  Out: [seen] is empty, so all rays continue.
; Source: derived here.

        .regs   r208, line_link, line_taken, line_where, line_to, line_normals

        .data
line_saved:     .space 21               ; event .. slot_size
line_part:      .space PART_SIZE        ; of one primitive
        .align  64
line_store:     .space 2 * QUEUE
        .code

; Stores [vector] in the next plane, for the lines of line_where.
        .macro  to_plane vector
        VTOVX   [line_where], \vector, [s4]
        ADDX    s4, line_stride, s4
        .endm

        .macro  to_plane_of_hits vector
        VXTOV   [taken_at], [\vector], [taken_distance]
        to_plane [taken_distance]
        VTOVX   [taken_at], r0, [\vector]       ; 0 for other primitives
        .endm

        .kernel lines
found_crossings:
        RTOR    link_kernel, line_link
        RTOR    seen, s5
        EX      target, found_points
        BSAVE   link_kernel, [target]
        take_found place, taken_at, 0, seen
        take_found event, taken_distance, 1, seen
        take_found event_met, taken_met, 2, seen
        LTOR    taken_at, line_taken
        describe line_where, line_store, line_taken
        describe s3, line_store + 64 * QUEUE, line_taken
        VXTOV   [taken_at], [line_counts], [line_where]
        ADDXV   one_index, [line_where], [s3]
        VTOVX   [taken_at], [s3], [line_counts]
        SHIFTI  line_step, -6, s2
        MPYLV   [line_where], s2, [line_where]
        ADDXV   [line_where], [taken_at], [line_where]
        .if     NORMALS
        EX      target, find_normals
        BSAVE   link_kernel, [target]
        .endif
        CFPEQ   line_behind, r0, found_from_origin
        SUBNV   [taken_distance], line_behind, [taken_distance]
found_from_origin:
        RTOR    seen_first, s4
        to_plane [taken_distance]
        to_plane [taken_met]

; The senses follow from the values after the crossings.
        RTOR    region, s6
        IX      s6, 64 * R_BODY
        LOD     [s6], s6
        SUBX    r0, s6, s7
        tree_value
        describe s3, line_store + 64 * QUEUE, near
        VTOV    s7, [s3]
        VTOV    s6, [s3] ? [value_after]
        take_found s3, taken_distance, 1, seen
        to_plane [taken_distance]
        to_plane_of_hits hit_s
        to_plane_of_hits hit_t
        VTOV    [after], [event] ? [seen]       ; within delta: the same place
        XORB    [seen], [seen], [seen]
        BIM     0, line_link

        .if     NORMALS
; Computes the normals at these crossings, one primitive after another, and
; stores them in their planes. Scratch registers of other routines are
; preserved.
find_normals:
        RTOR    link_kernel, line_normals
        EX      s3, line_saved
        ELEN    s3, 21
        SWAP    [r0], event, [s3]
        EX      part_at, line_part
        leaves_begin
normals_leaf:
        load_leaf_record
        load_field P_ID, identity
        describe near_bits, queue_bits, line_taken
        CMPEQV  [taken_met], identity, [near_bits]
        CNTOB   [near_bits], h
        IBXEQ   h, r0, r0, normals_next
        EX      target, set_hits
        BSAVE   link_inner, [target]
        RTOR    h, m
        EX      line_to, line_store + 64 * QUEUE
        CPSV    [taken_at], [at] ? [near_bits]
        CPSV    [taken_distance], [v0] ? [near_bits]
        CPSV    [line_where], [line_to] ? [near_bits]
        point   aox, adx, px, hdx
        point   aoy, ady, py, hdy
        point   aoz, adz, pz, hdz
        EX      target, find_normal
        BSAVE   link_kernel, [target]
        ES      s4, SEEN_NORMAL
        MPYX    line_stride, s4, s4
        ADDX    seen_first, s4, s4
        VTOVX   [line_to], [nx], [s4]
        ADDX    s4, line_stride, s4
        VTOVX   [line_to], [ny], [s4]
        ADDX    s4, line_stride, s4
        VTOVX   [line_to], [nz], [s4]
normals_next:
        leaves_next normals_leaf
        EX      s3, line_saved
        ELEN    s3, 21
        SWAP    [s3], event, [r0]
        BIM     0, line_normals
        .endif
        .endkernel
