; points_vector.s - generates the points of points_program.s in queues.

        .include "points/lattice.s"
        .include "points/points_program.s"

        .regs   r16, points_x, states_at, states, leap
        stream_vector_registers r61
        .regs   r63, plane, points_now, points_queue, points_work

        .data
points_states:  .space QUEUE            ; states of rays, or numbers of points
points_scratch: .space 1
        .code

        .macro  make_coordinate coordinate
        .kernel points
        .if     LATTICE
        lattice_coordinate states, \coordinate, result0
        .else
        stream_draw states, \coordinate, result0, points_work
        .endif
        .endkernel
        .if     NUMBERS
        .kernel units
        stream_unit result0, result0
        .endkernel
        .endif
        .endm

        .entry  points_vector
points_vector:
        .kernel begin
        points_begin
        stream_vector_load
        EX      plane, points_results
        EX      points_left, POINTS
        EX      points_queue, QUEUE
        EX      states_at, points_states
        .if     1 - LATTICE
        RTOR    points_queue, work0
        IBXGE   points_queue, r0, points_left, points_short
        BIM     points_seed_stream
points_short:
        RTOR    points_left, work0
points_seed_stream:
        stream_seeds states_at, work0, points_x, work1, work2, work3, work4, work5
        stream_leap points_queue, leap, work0, work1, work2
        .endif
        .endkernel

points_next:
        .kernel queue
        RTOR    points_queue, points_now
        IBXGE   points_left, r0, points_queue, points_full
        RTOR    points_left, points_now
points_full:
        ADDLEN  states_at, points_now, states
        EX      points_work, points_scratch
        ADDLEN  points_work, points_now, points_work
        .if     LATTICE
        INTVLV  points_i, stream_one, [states]
        ADDX    points_i, points_now, points_i
        .endif
        ADDLEN  plane, points_now, result0
        .endkernel
        .rept   COORDINATES
        make_coordinate \+
        .kernel queue
        IX      result0, 64 * POINTS
        .endkernel
        .endr
        .kernel queue
        SHIFTI  points_now, 6, work0
        ADDX    plane, work0, plane
        .if     1 - LATTICE
        MPYLV   [states], leap, [states]
        .endif
        SUBX    points_left, points_now, points_left
        IBXNE   points_left, r0, r0, points_next
        .endkernel
        points_done
