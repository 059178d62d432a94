; roots_records.s - what the host lays out for the programs roots_scalar.s and
; roots_vector.s, which find the roots of a list of polynomials.
;
; All in planes, one number a polynomial, as many as roots_polynomials says.
; Results: how many roots were found, then the first to the fourth; -1 for a
; polynomial whose coefficients the machine's exponents cannot bring together
; (scaling_vector.s).

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
roots_polynomials: .word 0              ; how many, an integer
roots_wanted:      .word 0              ; of each, at most: 1 or 4
roots_inputs:      .word 0              ; address of the first plane
roots_results:     .word 0              ; likewise

; Constants of both programs.
        .equ    SCALING_CONSTANTS, 10
scaling_constants:
        .word   1.0, 2.0, 3.0, 4.0, 46.0
        .word   6900.0                  ; the most that one coefficient may be
                                        ; above the outer two, log2
        .word   28000.0                 ; of an exponent
        .word   -20000.0                ; below that a coefficient is 0
        .word   X'0000 4000 0000 0000'  ; the coefficient 2^46
        .word   1                       ; the integer
        .code
