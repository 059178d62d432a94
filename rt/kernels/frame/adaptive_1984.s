; adaptive_1984.s - adaptive sampling (adaptive.s) in kernels mode.
;
; The scalar program visits the pixels and computes the means. Samples form
; queues in the order of the list. Called by link_kernel.

        .macro  by_scalar_program routine
        to_scalar
        call_routine \routine, link
        to_vector
        .endm

        .kernel frame
begin_fine:
        by_scalar_program fine_begin
        BIM     0, link_kernel
next_fine:
        by_scalar_program fine_next
        EX      s0, scene_tiles
        STO     [s0], r0
        EX      s0, scene_first_pixel
        STO     [s0], r0
        BIM     0, link_kernel
average_fine:
        by_scalar_program fine_average
        BIM     0, link_kernel
end_fine:
        by_scalar_program fine_end
        BIM     0, link_kernel
        .endkernel
