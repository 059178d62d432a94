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
        store_word r0, scene_tiles, s0
        store_word r0, scene_first_pixel, s0
        BIM     0, link_kernel
average_fine:
        by_scalar_program fine_average
        BIM     0, link_kernel
end_fine:
        by_scalar_program fine_end
        BIM     0, link_kernel
        .endkernel
