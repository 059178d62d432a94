; query_scalar.s - all visible crossings along lines: the scalar form.
;
; Arguments and results: query.s.

        .include "frame/records.s"
        .include "frame/linkage.s"
        .include "frame/vectors_scalar.s"
        .include "query/query.s"

; Words that the host reserves for each crossing and each value of a tree.
        .equ    CROSSING_SIZE, 1
        .equ    VALUE_SIZE, 1

; Registers of the main program, in addition to those of linkage.s.
        .regs   r156, line_ox, line_oy, line_oz, line_dx, line_dy, line_dz
        .regs   r162, line_least, line_lower, line_behind, line_stride
        .regs   r166, line_step, line_at, line_counts, line_found, lines_left
        .regs   r171, line_length, line_work, seen_at, seen_left, seen_plane, seen_slot

        .include "shapes/slab_scalar.s"
        .include "shapes/quadratic_scalar.s"
        .include "shapes/every_scalar.s"
        .include "frame/transform_scalar.s"
        .include "frame/bound_scalar.s"
        .include "solids/visible_scalar.s"
        .include "solids/span_scalar.s"
        .include "solids/nodes_scalar.s"
        .include "frame/hierarchy_scalar.s"
        .include "frame/regions_scalar.s"
        .include "light/pigment_scalar.s"
        .include "light/surface_scalar.s"
        .include "shapes/normal_scalar.s"
        .include "shapes/every_normal_scalar.s"
        .include "query/seen_scalar.s"
        .include "solids/unseen_scalar.s"

        .data
line_ray:       .space 8
line_list:      .descriptor 8, line_ray
line_room:      .word 0
                .descriptor 1, line_seen
line_seen:      .space 1
        .code

; Loads the line's word of the next plane.
        .macro  load_of_line register
        LOD     [line_work], \register
        ADDX    line_work, line_stride, line_work
        .endm

; Moves the start of the line back by line_behind.
        .macro  move_behind o, d
        MPYS    line_behind, \d, line_work
        SUBN    \o, line_work, \o
        .endm

; Loads the number of the line's crossings and the address of the first one.
        .macro  load_seen
        load_of line_seen, seen_left
        load_of lines_list, seen_at
        .endm

; Copies the next word of the crossing at seen_at to its plane.
        .macro  store_in_plane
        LOD     [seen_at], line_work
        STO     [seen_plane], line_work
        IX      seen_at, 64
        ADDX    seen_plane, line_stride, seen_plane
        .endm

        .if     BODIES
        .include "query/depth_scalar.s"
        .endif

        .entry  lines
        .kernel lines
lines:
        load_main_constants
        load_of k_tmin, line_least
        load_of k_lower, line_lower
        load_of lines_behind, line_behind
        load_of lines_count, lines_left
        load_of lines_rays, line_at
        load_of lines_counts, line_counts
        load_of lines_found, line_found
        load_of lines_list, line_work
        EX      seen_at, line_room
        STO     [seen_at], line_work
        SHIFTI  lines_left, 6, line_stride
        ES      line_step, SEEN_SIZE
        MPYX    line_step, line_stride, line_step
lines_next:
        RTOR    line_at, line_work
        load_of_line line_ox
        load_of_line line_oy
        load_of_line line_oz
        load_of_line line_dx
        load_of_line line_dy
        load_of_line line_dz
        normalise_by m_one, line_dx, line_dy, line_dz, line_length, line_work
        CFPEQ   line_behind, r0, lines_begin
        move_behind line_ox, line_dx
        move_behind line_oy, line_dy
        move_behind line_oz, line_dz
lines_begin:
        EX      line_work, line_ray
        ELEN    line_work, 8
        SWAP    [r0], line_ox, [line_work]
        call    see_line, line_list
        load_seen
        STO     [line_counts], seen_left
        IBXEQ   seen_left, r0, r0, lines_stored
        .if     BODIES
        count_bodies_of_line
        .endif
        RTOR    line_found, seen_slot
lines_seen:
        RTOR    seen_slot, seen_plane
        .rept   SEEN_SIZE
        store_in_plane
        .endr
        ADDX    seen_slot, line_step, seen_slot
        IBXNE   seen_left, m_index_minus_one, r0, lines_seen, seen_left
lines_stored:
        IX      line_at, 64
        IX      line_counts, 64
        IX      line_found, 64
        IBXNE   lines_left, m_index_minus_one, r0, lines_next, lines_left
        EXIT
        .endkernel
