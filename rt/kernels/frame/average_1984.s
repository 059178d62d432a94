; average_1984.s - averages the samples of a band in kernels mode.
;
; The scalar program does the work. Called by link_kernel.

        .kernel frame
average_1984:
        load_word scene_samples, s1
        IBXLE   s1, r0, one_index, average_not
        to_scalar
        call_routine average, link
        to_vector
average_not:
        BIM     0, link_kernel
        .endkernel
