; rays_vector.s - generates the rays of rays.s together, at most RAYS of them.
;
; The constant RAYS reserves words for the states of this number of rays.

        .ifndef RAYS
        .equ    RAYS, 4096
        .endif


        stream_vector_registers r71
        .regs   r73, ray_states_at, ray_states, ray_to, ray_u, ray_scratch, ray_high

        .data
        .align  64
ray_store:      .space 2 * RAYS
        .code

; [to] := one of the two coordinates of all points.
        .macro  ray_words coordinate, to
        .if     POINTS == POINTS_RANDOM
        stream_draw ray_states, \coordinate, \to, ray_scratch
        .else
        lattice_coordinate ray_states, \coordinate, \to
        .endif
        .endm

; Computes, from a coordinate in [ray_to], an integer, the position of the rays,
; and two planes later their origins.
        .macro  ray_place width, middle
        stream_unit ray_to, ray_to
        LINKV
        SUBNV   [ray_to], ray_half, [ray_u]
        MPYSV   [ray_u], \width, [ray_to]
        ADDX    ray_to, ray_stride, ray_u
        ADDX    ray_u, ray_stride, ray_u
        ADDNV   [ray_to], \middle, [ray_u]
        EX      ray_u, ray_store + 64 * RAYS
        ADDLEN  ray_u, ray_count, ray_u
        .endm

        .kernel rays
rays:
        rays_begin
        stream_vector_load
        EX      ray_states_at, ray_store
        ADDLEN  ray_states_at, ray_count, ray_states
        EX      ray_u, ray_store + 64 * RAYS
        ADDLEN  ray_u, ray_count, ray_u
        RTOR    ray_u, ray_scratch
        ADDLEN  ray_results, ray_count, ray_to
        .if     POINTS == POINTS_RANDOM
        stream_seeds ray_states_at, ray_count, ray_state, ray_work0, ray_work1, ray_work2, ray_work3, ray_work4
        .else
        INTVLV  ray_point, stream_one, [ray_states]
        .endif
        ray_words 0, ray_to
        ray_place ray_width_p, ray_middle_p
        ADDX    ray_to, ray_stride, ray_to
        .if     POINTS == POINTS_GRID
        SHIFTV  [ray_states], ray_low, [ray_states]
        .endif
        ray_words 1, ray_to
        ray_place ray_width_q, ray_middle_q
        EXIT
        .endkernel
