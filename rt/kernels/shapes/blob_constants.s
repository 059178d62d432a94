; blob_constants.s - the numbers of both forms of the blob's kernels.

        .data
blob_numbers:   .word 0.25, 0.16666666666666667, 4.0
        .code
