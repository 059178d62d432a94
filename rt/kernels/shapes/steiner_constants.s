; steiner_constants.s - the numbers of both forms of the Steiner kernels.
;
; Parameters count that lie at most 2^-40 outside of the patch: two patches
; that share an edge leave no gap.

        .data
patch_limits:   .word X'FFA9 8000 0000 0000'    ; -2^-40, as low
                .word 1.0000000000009095        ; 1 + 2^-40
                .word X'FFA6 4000 0000 0000'    ; 2^-44: closeness of roots
patch_numbers:  .word 0.25, 0.16666666666666667
                .word X'FFAC 4000 0000 0000'    ; 2^-38: noise of Bernstein
                                                ; coefficients
                .word X'FFB4 4000 0000 0000'    ; 2^-30: Newton's last step
implicit_numbers:
                .word X'FFB3 8000 0000 0000'    ; -2^-30, as low
                .word 1.000000000931322         ; 1 + 2^-30
                .word X'FFBE 4000 0000 0000'    ; 2^-20: of bound^2, nothing
                                                ; for N^2
        .code
