; frame_scalar.s - computes a frame ray by ray: the scalar form of the tracer.
;
; For each pixel of the band it generates the ray, traces it and stores the
; result. Operations and their order are those of the vector form, so both forms
; give the same frame, bit for bit.

        .include "frame/records.s"
        .if     ADAPTIVE
        .include "frame/adaptive.s"
        .endif
        .equ    CASTS_SHADOWS, 1
        .include "frame/linkage.s"
        .include "frame/vectors_scalar.s"
        .include "light/power_constants.s"

; Words that the host reserves for each crossing and each value of a tree.
; levels_scalar.s has those of a level of reflection.
        .equ    CROSSING_SIZE, 1
        .equ    VALUE_SIZE, 1

; Registers of the main program in addition to those of linkage.s and
; levels_scalar.s: levels of reflection, which kernels see too, then its own.
        .regs   r13, level, levels_left, first_level, trace_link
        .regs   r156, column, width, row, last_row, hit_id, plane_size
        .reg    plane_at, r162

        .include "shapes/forms_scalar.s"
        .include "shapes/every.s"
        .include "frame/transform_scalar.s"
        .include "frame/camera.s"
        .include "frame/forms_scalar.s"
        .if     LENS
        .include "frame/lens.s"
        .endif
        .include "frame/generate.s"
        .include "frame/bound_scalar.s"
        .include "solids/visible_scalar.s"
        .include "solids/span_scalar.s"
        .include "solids/nodes_scalar.s"
        .include "frame/hierarchy_scalar.s"
        .include "frame/regions_scalar.s"
        .include "light/forms_scalar.s"
        .include "light/transmitted_scalar.s"
        .include "light/shadow_scalar.s"
        .include "light/power.s"
        .include "light/pigment_scalar.s"
        .include "light/sky_scalar.s"
        .include "light/surface_scalar.s"
        .include "shapes/normal_scalar.s"
        .include "shapes/every_normal.s"
        .include "light/light.s"
        .include "light/shade_scalar.s"
        .include "light/spawn_scalar.s"
        .include "solids/levels_scalar.s"

        .data
pixel:          .space 2
generate_list:  .descriptor 2, pixel
                .descriptor VIEW_SIZE, view
generate_place: .word 0
        .if     ADAPTIVE
frame_sample_number: .word 0            ; number of the sample that is traced
        .endif
        .code

        .if     ADAPTIVE
        .include "frame/places.s"
        .endif

        .entry  frame
        .kernel frame
frame:
        load_main_constants
        load_words power_constants, POWER_CONSTANTS, p_47
        call_routine camera, link
        call_routine levels_begin, trace_link
        EX      main_at, shadow_ray + 64 * 6
        load_word k_shadow, main_t
        STO     [main_at], main_t
        load_word k_shadow_lower, main_t
        STO     [main_at, m_index_one], main_t
        RTOR    first_level, main_t
        ELEN    main_t, 6
        store_word main_t, generate_place, main_at
        load_words scene_band, 2, row
        load_word scene_width, width
        load_word scene_pixels, plane_size
        store_word plane_size, rays_primary, main_at
        SHIFTI  plane_size, 6, plane_size
        load_word scene_frame, plane_at
        .if     ADAPTIVE
        load_words scene_wide, 1, width
        load_place_steps
        through_middle width, width
        through_middle row, row
        through_middle last_row, last_row
        .endif
frame_row:
        .if     ADAPTIVE
        load_place_steps
        RTOR    place_first, column
        .else
        RTOR    m_zero, column
        .endif
frame_pixel:
        EX      main_at, pixel
        STO     [main_at], column
        STO     [main_at, m_index_one], row
frame_aimed:
        call    generate_ray, generate_list
        call_routine trace, trace_link
        RTOR    first_level, level
        load_level L_SAMPLE, 6, own_red
        IBXEQ   first_primitive, r0, r0, frame_background
        IX      first_primitive, 64 * P_ID
        LOD     [first_primitive], hit_id
        BIM     frame_store
frame_background:
        RTOR    m_zero, first_distance
        RTOR    m_zero, main_red
        RTOR    m_zero, main_green
        RTOR    m_zero, main_blue
        RTOR    m_zero, hit_id
frame_store:
        RTOR    plane_at, main_at
        store_step own_red, main_at, plane_size
        store_step own_green, main_at, plane_size
        store_step own_blue, main_at, plane_size
        store_step first_distance, main_at, plane_size
        store_step main_red, main_at, plane_size ; the normal
        store_step main_green, main_at, plane_size
        store_step main_blue, main_at, plane_size
        store_step hit_id, main_at, plane_size
        IX      plane_at, 64
        .if     ADAPTIVE
        load_words fine_list, 1, main_t
        IBXNE   main_t, r0, r0, frame_sample_traced
        load_place_steps
        ADDN    column, place_step, column
        CFPLT   column, width, frame_pixel
        ADDN    row, place_step, row
        CFPLT   row, last_row, frame_row
        call_routine fine_begin, link
frame_refine:
        call_routine fine_next, link
        load_words fine_rays, 1, plane_size
        IBXEQ   plane_size, r0, r0, frame_refined
        add_to_word rays_primary, plane_size, main_at, main_t
        SHIFTI  plane_size, 6, plane_size
        load_words scene_frame, 1, plane_at
        ES      main_t, 0
frame_sample:
        store_word main_t, frame_sample_number, main_at
        load_word scene_wide, place_width
        load_place_steps
        ADDN    main_t, r0, place_rest
        through_sample place_rest, place_width, column, row
        BIM     frame_pixel
frame_sample_traced:
        load_words frame_sample_number, 1, main_t
        IX      main_t, 1
        load_words fine_rays, 1, main_at
        IBXNE   main_t, r0, main_at, frame_sample
        call_routine fine_average, link
        BIM     frame_refine
frame_refined:
        call_routine fine_end, link
        .else
        ADDN    column, m_one, column
        CFPLT   column, width, frame_pixel
        ADDN    row, m_one, row
        CFPLT   row, last_row, frame_row
        call_routine average, link
        .endif
        EXIT
        .endkernel

        .include "frame/samples.s"
        .if     ADAPTIVE
        .include "frame/adaptive_scalar.s"
        .else
        .include "frame/average.s"
        .endif
        .include "solids/invisible_scalar.s"
