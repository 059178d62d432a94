; levels_scalar.s - traces one ray and all rays that it spawns, depth first.
;
; Part of the main program, called by trace_link. The ray is in the record of
; the first level. Its colour and normal are stored there, its hit in
; first_distance, first_primitive (0: none).
;
; FORTRAN has no recursion, so each level of reflection has a record with its
; ray, its sample and the waiting refracted ray. The reflected ray is traced to
; its end and added to its parent's colour, then the refracted ray:
;
;   colour = colour + factor x its colour
;
; The argument lists for the subroutine calls of a level are in its record too.
; They are made once.

        .record LEVEL
        .field  L_RAY, 6                ; O, D
        .field  L_MIN, 2              ; least distance, to be scaled
        .if     INTERIORS
        .field  L_PASSED                ; CHILD_PASSED
        .field  L_INSIDE                ; bodies that contain the ray
        .field  L_RAY_LEVEL             ; its level; straight rays keep it, so
                                        ; there are fewer levels than records
        .endif
        .field  L_WEIGHT
        .field  L_FACTOR, 3             ; factor of its colour in the parent's
        .field  L_SAMPLE, SAMPLE_SIZE   ; as in SHADE
        .field  L_FOLLOWED, 2           ; 1: a reflected, a refracted ray exists
        .field  L_WAITING, CHILD_SIZE   ; the waiting refracted ray
        .field  L_NEAREST, NEAREST_ARGUMENTS ; argument lists
        .field  L_SHADE, SHADE_ARGUMENTS
        .field  L_SPAWN, SPAWN_ARGUMENTS
        .if     GLOSS
        .field  L_PIGMENT, 3
        .endif
        .if     FOG
        .field  L_DISTANCE              ; length of the ray, for fog
        .endif
        .if     HIDDEN
        .field  L_CLASS                  ; IMAGE_RAYS or REFLECTED_RAYS
        .endif
        .at     64
        .endrecord

        .reg    sky_stops, r163         ; stops of scene_sky, or 0
        .regs   r240, first_distance, first_primitive, distance
        .regs   r243, hit_primitive, main_at, main_t
        .regs   r246, own_red, own_green, own_blue, main_red, main_green
        .regs   r251, main_blue

        .data
hit:            .space 2                ; distance, primitive
        .code

        .if     FOG
        .include "light/fog.s"
        .endif

        .macro  set_level offset, register
        address_of level, \offset, main_at
        STO     [main_at], \register
        .endm

        .macro  get_level offset, register
        address_of level, \offset, main_at
        LOD     [main_at], \register
        .endm

        .macro  load_level offset, number, first
        load_part level, \offset, \number, \first, main_at
        .endm

        .macro  store_level offset, number, first
        store_part \first, \number, level, \offset, main_at
        .endm

        .macro  call_level routine, list
        address_of level, \list, arguments
        call_routine \routine, link
        .endm

; Makes an argument: `number` words of the level's record from `offset` on.
        .macro  level_argument position, offset, number
        address_of level, \offset, main_t
        ELEN    main_t, \number
        set_level \position, main_t
        .endm

        .macro  hit_argument position, number
        EX      main_t, hit
        ELEN    main_t, \number
        set_level \position, main_t
        .endm

; Makes the argument lists of all levels, and the ray of the first.
        .kernel frame
levels_begin:
        load_word scene_sky + 64 * 4, sky_stops
        load_word scene_levels, level
        load_word scene_level_count, levels_left
        RTOR    level, first_level
levels_next:
        level_argument L_NEAREST, L_RAY, 6
        hit_argument L_NEAREST + 1, 2
        .if     HIDDEN
        level_argument L_NEAREST + 2, L_CLASS, 1
        .endif
        level_argument L_SHADE, L_RAY, 6
        hit_argument L_SHADE + 2, 1
        level_argument L_SHADE + 3, L_SAMPLE, SAMPLE_SIZE
        level_argument L_SPAWN, L_RAY, 6
        level_argument L_SPAWN + 2, L_SAMPLE + SAMPLE_NORMAL, SAMPLE_SIZE - SAMPLE_NORMAL
        level_argument L_SPAWN + 3, L_WEIGHT + 1 - SPAWN_STATE, SPAWN_STATE
        level_argument L_SPAWN + 4, L_FOLLOWED, 2
        level_argument L_SPAWN + 5, LEVEL_SIZE + L_RAY, CHILD_SIZE
        level_argument L_SPAWN + 6, L_WAITING, CHILD_SIZE
        .if     GLOSS
        level_argument L_SHADE + 4, L_PIGMENT, 3
        level_argument L_SPAWN + 7, L_PIGMENT, 3
        .endif
        IX      level, 64 * LEVEL_SIZE
        IBXNE   levels_left, m_index_minus_one, r0, levels_next, levels_left
        RTOR    first_level, level
        address_of level, L_MIN, main_at
        load_word k_lower, main_t
        STO     [main_at], m_tmin
        STO     [main_at, m_index_one], main_t
        .if     INTERIORS
        set_level L_PASSED, r0
        address_of level, L_INSIDE, main_at
        STO     [main_at], m_minus_one
        STO     [main_at, m_index_one], m_one
        .endif
        .if     HIDDEN
        address_of level, L_CLASS, main_at
        ES      main_t, IMAGE_RAYS
        STO     [main_at], main_t
        .endif
        set_level L_WEIGHT, m_one
        BIM     0, trace_link
        .endkernel

        .kernel frame
trace:
        RTOR    first_level, level
        load_word scene_level_count, levels_left
        call_level nearest, L_NEAREST
        load_words hit, 2, distance
        RTOR    distance, first_distance
        RTOR    hit_primitive, first_primitive
        BIM     trace_hit
trace_next:
        call_level nearest, L_NEAREST
        load_words hit, 2, distance
trace_hit:
        IBXEQ   hit_primitive, r0, r0, trace_background
        .if     FOG
        set_level L_DISTANCE, distance
        .endif
        set_level L_SHADE + 1, hit_primitive
        call_level shade, L_SHADE
        .endkernel
        .kernel spawn
        IBXEQ   levels_left, r0, m_index_one, trace_ended
        address_of hit_primitive, P_MIRROR, main_at
        LOD     [main_at], main_t
        LOD     [main_at, m_index_one], main_red
        OR      main_t, main_red, main_t
        IBXEQ   main_t, r0, r0, trace_ended
        set_level L_SPAWN + 1, hit_primitive
        call_level spawn, L_SPAWN
        get_level L_FOLLOWED, main_t
        IBXEQ   main_t, r0, r0, trace_waiting
        add_to_word rays_reflected, m_index_one, main_at, main_t
        .if     HIDDEN
        address_of level, LEVEL_SIZE + L_CLASS, main_at
        ES      main_t, REFLECTED_RAYS
        STO     [main_at], main_t
        .endif
        BIM     trace_down
trace_waiting:
        get_level L_FOLLOWED + 1, main_t
        IBXEQ   main_t, r0, r0, trace_ended
        STO     [main_at], r0
        .if     HIDDEN
        ES      main_at, REFLECTED_RAYS
        IBXEQ   main_t, r0, main_at, trace_class ; 2: total reflection
        get_level L_CLASS, main_t
trace_class:
        set_level LEVEL_SIZE + L_CLASS, main_t
        .endif
        address_of level, L_WAITING, main_at
        ELEN    main_at, CHILD_SIZE
        address_of level, LEVEL_SIZE + L_RAY, main_t
        ELEN    main_t, CHILD_SIZE
        SWAP    [main_at], r32, [r0]
        SWAP    [r0], r32, [main_t]
        add_to_word rays_refracted, m_index_one, main_at, main_t
trace_down:
        IX      level, 64 * LEVEL_SIZE
        ADDX    levels_left, m_index_minus_one, levels_left
        BIM     trace_next
        .endkernel

        .kernel frame
trace_background:
        .if     FOG
        load_word fog_far, main_t
        set_level L_DISTANCE, main_t
        .endif
        load_words scene_background, 3, own_red
        IBXEQ   sky_stops, r0, r0, trace_no_sky
        load_level L_RAY + 3, 3, own_red
        see_sky own_red, own_red
trace_no_sky:
        store_level L_SAMPLE, 3, own_red
        .endkernel
        .kernel resolve
trace_ended:
        .if     FOG
        get_level L_DISTANCE, fog_distance
        load_level L_SAMPLE, 3, own_red
        see_through_fog own_red, own_green, own_blue
        store_level L_SAMPLE, 3, own_red
        .endif
        IBXEQ   level, r0, first_level, trace_done
        load_level L_FACTOR, 6, own_red ; factor, colour
        IX      level, -64 * LEVEL_SIZE
        ADDX    levels_left, m_index_one, levels_left
        MPYS    own_red, main_red, main_red
        MPYS    own_green, main_green, main_green
        MPYS    own_blue, main_blue, main_blue
        load_level L_SAMPLE, 3, own_red
        ADDN    own_red, main_red, own_red
        ADDN    own_green, main_green, own_green
        ADDN    own_blue, main_blue, own_blue
        store_level L_SAMPLE, 3, own_red
        BIM     trace_waiting
trace_done:
        BIM     0, trace_link
        .endkernel
