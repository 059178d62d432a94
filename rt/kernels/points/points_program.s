; points_program.s - the common part of the two programs that generate points.
;
; They generate POINTS points and store them coordinate by coordinate. These
; constants may be defined:
;
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

        .ifndef QUEUE
        .equ    QUEUE, 2000
        .endif
        .ifndef POINTS
        .equ    POINTS, 2000
        .endif
        .ifndef LATTICE
        .equ    LATTICE, 0
        .endif
        .ifndef COORDINATES
        .equ    COORDINATES, 5
        .endif
        .ifndef NUMBERS
        .equ    NUMBERS, 1
        .endif

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

; Loads arguments and constants. For the stream, sets points_x to the state of
; the first ray.
        .macro  points_begin
        EX      points_at, points_arguments
        ELEN    points_at, 4
        SWAP    [points_at], points_s, [r0]
        stream_load points_at
        .if     LATTICE
        lattice_load points_log, points_s, points_k, work
        .else
        stream_state points_s, points_i, STREAM_DRAWS, points_x, work0, work1, work2
        .endif
        .endm
