; emission_vector.s - emission (emission_program.s), in queues.

        .macro  points_done
        .endm
        .include "points/points_vector.s"
        .include "heat/emission_program.s"
        .include "forms.s"

        .reg    emission_mask, r90
        .regs   r191, emission_now, emission_high
        vector_form , emission_mask

        .data
emission_bases:
        .rept   EMISSION_WORK
        .descriptor 0, emission_store + 64 * QUEUE * \+
        .endr
emission_descriptors:
        .space  EMISSION_WORK
emission_bits:  .space (QUEUE + 63) / 64
        .align  64
emission_store: .space QUEUE * EMISSION_WORK
        .code

; Makes descriptors of `count` planes in `register`, from the next point on and
; as long as the queue.
        .macro  emission_planes planes, count, register
        EX      emission_plane, \planes
        ADDX    emission_plane, emission_at, emission_plane
        ADDLEN  emission_plane, emission_now, emission_plane
        .rept   \count
        RTOR    emission_plane, \register
        ADDX    emission_plane, emission_stride, emission_plane
        .endr
        .endm

        .kernel begin
        emission_begin
        EX      emission_left, POINTS
        ES      emission_at, 0
        .endkernel

emission_next:
        .kernel queue
        RTOR    points_queue, emission_now
        IBXGE   emission_left, r0, points_queue, emission_full
        RTOR    emission_left, emission_now
emission_full:
        SHIFTI  emission_now, 48, emission_high
        EX      emission_plane, emission_bases
        ELEN    emission_plane, EMISSION_WORK
        EX      piece_at, emission_descriptors
        ELEN    piece_at, EMISSION_WORK
        ORV     [emission_plane], emission_high, [piece_at]
        SWAP    [piece_at], local_spot_x, [r0]
        EX      emission_mask, emission_bits
        ADDLEN  emission_mask, emission_now, emission_mask
        emission_planes points_results, STREAM_DRAWS, draw\+
        emission_planes emission_results, EMITTED_SIZE, emitted\+
        BSAVE   emission_link, [emission_kernel]
        SHIFTI  emission_now, 6, emission_high
        ADDX    emission_at, emission_high, emission_at
        SUBX    emission_left, emission_now, emission_left
        IBXNE   emission_left, r0, r0, emission_next
        EXIT
        .endkernel

        .include "heat/emission_kernels.s"
