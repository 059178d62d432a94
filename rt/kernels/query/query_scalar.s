; query_scalar.s - all visible crossings along rays: the scalar form.
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
        .regs   r156, query_ox, query_oy, query_oz, query_dx, query_dy, query_dz
        .regs   r162, query_least, query_lower, query_start_distance, query_stride
        .regs   r166, query_step, query_at, query_counts_at, query_hits_at, query_left
        .regs   r171, query_length, query_work, ray_hit_at, ray_hits_left, ray_hit_plane, ray_hit_slot

        .include "shapes/forms_scalar.s"
        .include "shapes/every.s"
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
        .include "shapes/every_normal.s"
        .include "query/ray_hits_scalar.s"
        .include "solids/invisible_scalar.s"

        .data
query_ray:      .space 8
query_arguments: .descriptor 8, query_ray
query_hits_buffer: .word 0
                .descriptor 1, query_hit_count
query_hit_count: .space 1
        .code

; Loads the ray's word of the next plane.
        .macro  load_of_query register
        LOD     [query_work], \register
        ADDX    query_work, query_stride, query_work
        .endm

; Moves the start of the ray back by query_start_distance.
        .macro  move_behind o, d
        MPYS    query_start_distance, \d, query_work
        SUBN    \o, query_work, \o
        .endm

; Loads the number of the ray's crossings and the address of the first one.
        .macro  begin_ray_hits
        load_word query_hit_count, ray_hits_left
        load_word query_list, ray_hit_at
        .endm

        .macro  next_ray_hit again
        IX      ray_hit_at, 64 * RAY_HIT_SIZE
        IBXNE   ray_hits_left, m_index_minus_one, r0, \again, ray_hits_left
        .endm

        .macro  plane_of field, into
        ES      \into, \field
        .endm

; Copies the next word of the crossing at ray_hit_at to its plane.
        .macro  store_in_plane
        LOD     [ray_hit_at], query_work
        STO     [ray_hit_plane], query_work
        IX      ray_hit_at, 64
        ADDX    ray_hit_plane, query_stride, ray_hit_plane
        .endm

        .if     DEPTHS
        .include "query/depth_scalar.s"
        .endif

        .entry  lines
        .kernel lines
lines:
        load_main_constants
        load_word k_tmin, query_least
        load_word k_lower, query_lower
        load_word query_start, query_start_distance
        load_word query_count, query_left
        load_word query_rays, query_at
        load_word query_counts, query_counts_at
        load_word query_hits, query_hits_at
        load_word query_list, query_work
        store_word query_work, query_hits_buffer
        SHIFTI  query_left, 6, query_stride
        ES      query_step, RAY_HIT_SIZE
        MPYX    query_step, query_stride, query_step
        .if     DEPTHS
        load_depth_planes
        .endif
query_next:
        RTOR    query_at, query_work
        load_of_query query_ox
        load_of_query query_oy
        load_of_query query_oz
        load_of_query query_dx
        load_of_query query_dy
        load_of_query query_dz
        normalise_by m_one, query_dx, query_dy, query_dz, query_length, query_work
        CFPEQ   query_start_distance, r0, query_begin
        move_behind query_ox, query_dx
        move_behind query_oy, query_dy
        move_behind query_oz, query_dz
query_begin:
        store_words query_ox, 8, query_ray
        call    find_ray_hits, query_arguments
        begin_ray_hits
        STO     [query_counts_at], ray_hits_left
        IBXEQ   ray_hits_left, r0, r0, query_stored
        .if     DEPTHS
        count_depths_of_ray
        begin_ray_hits
        .endif
        RTOR    query_hits_at, ray_hit_slot
query_hit:
        RTOR    ray_hit_slot, ray_hit_plane
        .rept   RAY_HIT_SIZE
        store_in_plane
        .endr
        ADDX    ray_hit_slot, query_step, ray_hit_slot
        IBXNE   ray_hits_left, m_index_minus_one, r0, query_hit, ray_hits_left
query_stored:
        IX      query_at, 64
        IX      query_counts_at, 64
        IX      query_hits_at, 64
        IBXNE   query_left, m_index_minus_one, r0, query_next, query_left
        EXIT
        .endkernel
