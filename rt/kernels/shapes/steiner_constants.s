; steiner_constants.s - constants of the Steiner kernels, for the scalar and the
; vector form.
;
; Parameters up to 2^-40 outside the patch count as inside, so two patches that
; share an edge leave no gap.

        .data
patch_limits:   .word X'FFA9 8000 0000 0000'    ; -2^-40, as low
                .word 1.0000000000009095        ; 1 + 2^-40
                .word X'FFA6 4000 0000 0000'    ; 2^-44: closeness of roots
patch_numbers:  .word 0.25, 0.16666666666666667
                .word X'FFAC 4000 0000 0000'    ; 2^-38: rounding of Bernstein
                                                ; coefficients
                .word X'FFB4 4000 0000 0000'    ; 2^-30: Newton's last step
implicit_numbers:
                .word X'FFB3 8000 0000 0000'    ; -2^-30, as low
                .word 1.000000000931322         ; 1 + 2^-30
                .word X'FFBE 4000 0000 0000'    ; 2^-20: N^2 below this share of
                                                ; bound^2 counts as 0
        .code
