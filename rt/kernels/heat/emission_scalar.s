; emission_scalar.s - emission (emission_program.s), one point after another.

        .macro  points_done
        .endm
        .include "points/points_scalar.s"
        .include "heat/emission_program.s"
        .include "heat/columns_scalar.s"

        .kernel begin
        emission_begin
        EX      emission_left, POINTS
        ES      emission_at, 0
        .endkernel

emission_next:
        .kernel queue
        EX      column_at, points_made
        .rept   STREAM_DRAWS
        LOD     [column_at, emission_at], draw\+
        ADDX    column_at, column_stride, column_at
        .endr
        BSAVE   emission_link, [emission_kernel]
        EX      column_at, emission_made
        .rept   EMITTED_SIZE
        STO     [column_at, emission_at], emitted\+
        ADDX    column_at, column_stride, column_at
        .endr
        IBXNE   emission_at, stream_one, emission_left, emission_next, emission_at
        EXIT
        .endkernel

        .include "heat/emission_kernels.s"
