; blob_constants.s - constants of the blob kernels, for the scalar and the
; vector form.

        .data
blob_numbers:   .word 0.25, 0.16666666666666667, 4.0
        .code
