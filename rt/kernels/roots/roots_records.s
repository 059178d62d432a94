; roots_records.s - the data that the host writes for the programs
; roots_scalar.s and roots_vector.s, which compute the roots of a list of
; polynomials.
;
; All data are in planes with one number per polynomial; roots_polynomials is
; their length.  Results: the number of roots, then the first to the fourth; -1
; for a polynomial whose coefficients cannot be scaled to the machine's
; exponents (scaling_vector.s).

        .equ    MAX_ROOTS, 4
        .record INPUT
        .field  INPUT_COEFFICIENTS, 5   ; c4 c3 c2 c1 c0
        .field  INPUT_BOUND
        .endrecord
        .record RESULT
        .field  RESULT_COUNT
        .field  RESULT_ROOTS, MAX_ROOTS
        .endrecord

        .data
roots_polynomials: .word 0              ; their number, an integer
roots_wanted:      .word 0              ; maximum for each: 1 or 4
roots_inputs:      .word 0              ; address of the first plane
roots_results:     .word 0              ; address of the first plane

; Constants of both programs.
        .equ    SCALING_CONSTANTS, 10
scaling_constants:
        .word   1.0, 2.0, 3.0, 4.0, 46.0
        .word   6900.0                  ; log2 of the largest ratio of a
                                        ; coefficient to the outer two
        .word   28000.0                 ; largest exponent
        .word   -20000.0                ; a coefficient below this is 0
        .word   X'0000 4000 0000 0000'  ; the coefficient 2^46
        .word   1                       ; the integer
        .code
