; points_scalar.s - generates the points of points_program.s one by one.

        .include "points/lattice.s"
        .include "points/points_program.s"

        .reg    points_x, r16           ; state of the ray
        .regs   r40, plane0, plane1, plane2, plane3, plane4, plane5

        .entry  points_scalar
points_scalar:
        .kernel begin
        points_begin
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
        points_done
