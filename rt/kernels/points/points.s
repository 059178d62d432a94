; points.s - generates points and stores them coordinate by coordinate.
;
; The scalar form makes point after point, the vector form makes them in queues,
; coordinate after coordinate. These constants may be defined:
;
;   SCALAR       the form is scalar, otherwise vector
;   QUEUE        points at a time, in the vector form (2000)
;   POINTS       1 .. 65535 (2000)
;   LATTICE      1: points of the lattice, 0: draws of the random stream (0)
;   COORDINATES  of a point: 1 .. 6 of the lattice, 5 of the stream (5)
;   NUMBERS      1: numbers in (0, 1), 0: the 47-bit integers that they are
;                made of (1)
;
; In:  points_seed; points_first, the number of the first ray or point; for the
;      lattice points_m and points_shift: N = 2^m points, the shift k; integers.
; Out: points_results, POINTS words for each coordinate.

        .include "points/lattice.s"

        option  QUEUE, 2000
        option  POINTS, 2000
        option  LATTICE
        option  COORDINATES, 5
        option  NUMBERS, 1

        .data
points_arguments:
points_seed:    .word 0
points_first:   .word 0
points_m:       .word 20
points_shift:   .word 0
points_results: .space POINTS * COORDINATES
        .code

; Runs after the points. A program that continues with them defines its own
; macro.
        .ifndef points_done
        .macro  points_done
        EXIT
        .endm
        .endif

        .regs   r10, points_s, points_i, points_log, points_k ; arguments
        .regs   r14, points_at, points_left
        .regs   r20, result0, result1, result2, result3, result4, result5
        .regs   r26, work0, work1, work2, work3, work4, work5
        stream_registers r32
        lattice_registers r48

        .ifdef  SCALAR
        .reg    points_x, r16           ; state of the ray
        .regs   r40, plane0, plane1, plane2, plane3, plane4, plane5
        .else
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
        .endif

        .entry  points
points:
        .kernel begin
        load_words points_arguments, 4, points_s, points_at
        stream_load points_at
        .if     LATTICE
        lattice_load points_log, points_s, points_k, work
        .else
        stream_state points_s, points_i, STREAM_DRAWS, points_x, work0, work1, work2
        .endif
        .ifdef  SCALAR
        ES      points_at, 0
        EX      points_left, POINTS
        .rept   COORDINATES
        EX      plane\+, points_results + 64 * POINTS * \+
        .endr
        .endkernel
points_next:
        .kernel points
        .if     LATTICE
        lattice_words points_i, COORDINATES, result\+
        ADDX    points_i, stream_one, points_i
        .else
        stream_words points_x, result\+, work\+
        .endif
        .endkernel
        .if     NUMBERS
        .kernel units
        stream_units COORDINATES, result\+, result\+
        .endkernel
        .endif
        .kernel store
        .rept   COORDINATES
        STO     [plane\+, points_at], result\+
        .endr
        IBXNE   points_at, stream_one, points_left, points_next, points_at
        .endkernel

        .else
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
        describe points_work, points_scratch, points_now
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
        advance_by plane, points_now, work0
        .if     1 - LATTICE
        MPYLV   [states], leap, [states]
        .endif
        SUBX    points_left, points_now, points_left
        IBXNE   points_left, r0, r0, points_next
        .endkernel
        .endif
        points_done
