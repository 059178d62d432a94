; emission_scalar.s - emission (emission_program.s), one point after another.

        .macro  points_done
        .endm
        .include "points/points_scalar.s"
        .include "heat/emission_program.s"
        .include "forms.s"

        .regs   r191, first, second, third
        scalar_form , first, second, third

        .kernel begin
        emission_begin
        EX      emission_left, POINTS
        ES      emission_at, 0
        .endkernel

emission_next:
        .kernel queue
        EX      emission_plane, points_results
        .rept   STREAM_DRAWS
        LOD     [emission_plane, emission_at], draw\+
        ADDX    emission_plane, emission_stride, emission_plane
        .endr
        BSAVE   emission_link, [emission_kernel]
        EX      emission_plane, emission_results
        .rept   EMITTED_SIZE
        STO     [emission_plane, emission_at], emitted\+
        ADDX    emission_plane, emission_stride, emission_plane
        .endr
        IBXNE   emission_at, stream_one, emission_left, emission_next, emission_at
        EXIT
        .endkernel

        .include "heat/emission_kernels.s"
