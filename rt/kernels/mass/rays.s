; rays.s - the parallel rays of one view, for a part of one shift.
;
; Columns through a solid are made of these rays. A view looks along one axis,
; k. The other axes, p and q, follow it in the order x, y, z, x, y. Ray i begins
; at
;
;   p = w_p (u_0 - 1/2)     x_p = c_p + p       u: the point number first + i
;   q = w_q (u_1 - 1/2)     x_q = c_q + q
;
; where c is the middle of the box around the solids and w its width. Points are
; those of a lattice (points/lattice.s), of a shifted square grid,
;
;   u_0 = i 2^-h + shift_0 mod 1        h = m / 2, rounded down
;   u_1 = (i / 2^h, rounded down) 2^(h-m) + shift_1 mod 1
;
; or the first two draws of a ray of the random stream (points/stream.s),
; with the number rays_number + first + i.
;
; Constants: POINTS, 0: of the stream, 1: of the lattice, 2: of the grid; RAYS, the
; most rays of the vector form.
; In:  the words below.
; Out: at rays_results planes of rays_count words: p, q, x_p, x_q, lengths in the
;      world.
; Source: random shifts, R. Cranley, T. N. L. Patterson (1976); the rest is
; derived here.

        .include "points/planes.s"
        .include "points/lattice.s"

        option  POINTS, 1
        option  RAYS, 4096
        .equ    POINTS_RANDOM, 0
        .equ    POINTS_GRID, 2

        .data
rays_arguments:
rays_seed:      .word 0                 ; integers
rays_first:     .word 0                 ; number of the first point
rays_m:         .word 0                 ; of 2^m points
rays_shift:     .word 0                 ; number of the shift
rays_number:    .word 0                 ; number of the stream's ray for point 0
rays_count:     .word 0                 ; number of rays
rays_results:   .word 0                 ; address of four planes
rays_width:     .word 0.0, 0.0          ; w_p, w_q
rays_middle:    .word 0.0, 0.0          ; c_p, c_q
                .word 0.5
                .equ    RAYS_ARGUMENTS, 12
        .code

        .regs   r10, ray_seed, ray_point, ray_log, ray_shift, ray_number, ray_count, ray_results
        .regs   r17, ray_width_p, ray_width_q, ray_middle_p, ray_middle_q, ray_half
        stream_registers r32
        lattice_registers r48
        .regs   r62, ray_work0, ray_work1, ray_work2, ray_work3, ray_work4, ray_work5
        .regs   r68, ray_state, ray_stride, ray_low

        .regs   r71, ray_i, ray_q_at, ray_x0_at, ray_x1_at, ray_scratch, ray_bits
        .regs   r77, ray_y0, ray_y1, ray_y2, ray_y3, ray_y4, ray_x0, ray_x1

        planes  ray_i, stream_one, ray_count, ray_scratch, ray_bits

        .ifdef  SCALAR
; Computes the words of the next ray's point, ray_y0 and ray_y1.
        .macro  ray_words
        .if     POINTS == POINTS_RANDOM
        stream_words ray_state, ray_y\+, ray_work\+
        .else
        .if     POINTS == POINTS_GRID
        SHIFT   ray_point, ray_low, ray_work0
        MPYL    lattice_z0, ray_point, ray_y0
        MPYL    lattice_z1, ray_work0, ray_y1
        ADDX    ray_y0, lattice_shift0, ray_y0
        ADDX    ray_y1, lattice_shift1, ray_y1
        AND     ray_y0, lattice_mask, ray_y0
        AND     ray_y1, lattice_mask, ray_y1
        .else
        lattice_words ray_point, 2, ray_y\+
        .endif
        ADDX    ray_point, stream_one, ray_point
        .endif
        .endm

        .macro  ray_units
        stream_units 2, ray_y\+, ray_y\+
        .endm
        .else
        stream_vector_registers r90
        .regs   r92, ray_states_at, ray_states

        .data
        .align  64
ray_store:      .space RAYS
        .code

; The same for all rays.
        .macro  ray_words
        stream_vector_load
        EX      ray_states_at, ray_store
        ADDLEN  ray_states_at, ray_count, ray_states
        plane   ray_results, ray_y0
        .if     POINTS == POINTS_RANDOM
        stream_seeds ray_states_at, ray_count, ray_state, ray_work0, ray_work1, ray_work2, ray_work3, ray_work4
        plane   ray_q_at, ray_y1
        stream_draw ray_states, 0, ray_y0, ray_y1
        stream_draw ray_states, 1, ray_y1, ray_y0
        .else
        INTVLV  ray_point, stream_one, [ray_states]
        plane   ray_q_at, ray_y1
        lattice_coordinate ray_states, 0, ray_y0
        .if     POINTS == POINTS_GRID
        SHIFTV  [ray_states], ray_low, [ray_states]
        .endif
        lattice_coordinate ray_states, 1, ray_y1
        .endif
        .endm

        .macro  ray_units
        stream_unit ray_y0, ray_y0
        stream_unit ray_y1, ray_y1
        .endm
        .endif

        .entry  rays
        .kernel rays
rays:
        load_words rays_arguments, RAYS_ARGUMENTS, ray_seed, ray_work0
        SHIFTI  ray_count, 6, ray_stride
        stream_load ray_work0
        .if     POINTS == POINTS_RANDOM
        ADDX    ray_number, ray_point, ray_number
        stream_state ray_seed, ray_number, STREAM_DRAWS, ray_state, ray_work0, ray_work1, ray_work2
        .else
        lattice_load ray_log, ray_seed, ray_shift, ray_work
        .endif
        .if     POINTS == POINTS_GRID
        SHIFTI  ray_log, -1, ray_work0          ; h
        SUBX    r0, ray_work0, ray_low
        ES      ray_work1, 47
        SUBX    ray_work1, ray_work0, ray_work2
        SHIFT   stream_one, ray_work2, lattice_z0
        SUBX    ray_log, ray_work0, ray_work2
        SUBX    ray_work1, ray_work2, ray_work2
        SHIFT   stream_one, ray_work2, lattice_z1
        .endif
        ADDX    ray_results, ray_stride, ray_q_at
        ADDX    ray_q_at, ray_stride, ray_x0_at
        ADDX    ray_x0_at, ray_stride, ray_x1_at
        each    rays_next
        ray_words
        ray_units
        plane   ray_x0_at, ray_x0
        plane   ray_x1_at, ray_x1
        lowered_scale_two ray_y0, ray_half, ray_width_p, ray_y0, ray_y1, ray_half, ray_width_q, ray_y1
        raise   ray_y0, ray_middle_p, ray_x0
        raise   ray_y1, ray_middle_q, ray_x1
        store   ray_y0, ray_results
        store   ray_y1, ray_q_at
        store   ray_x0, ray_x0_at
        store   ray_x1, ray_x1_at
        next    rays_next
        EXIT
        .endkernel
