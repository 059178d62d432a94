; quartic_constants.s - the rule of regula falsi, the limits and the constants
; that both forms of the root solver share.
;
; FALSI selects how the value at the end A of the bracket is reduced when the
; new point X is on the side of the newest end B, so that A is kept.  It is
; selected when the program is assembled; measured clocks decided the default
; (docs/quartic.md).
;
;   PAPER            f(A) is halved once A has been kept twice in a row.  The
;                    paper says only "Modified Regula Falsi"; this is the
;                    smallest change that keeps regula falsi from stalling.
;   ILLINOIS         f(A) is halved each time
;   PEGASUS          f(A) is multiplied by f(B) / (f(B) + f(X))
;   ANDERSON_BJORCK  by 1 - f(X) / f(B) if that is above 0, else by 1/2
;
; Sources: Dowell and Jarratt, BIT 11 (1971) 168-174 and BIT 12 (1972) 503-508;
; Anderson and Bjorck, BIT 13 (1973) 253-264.

        .equ    PAPER, 0
        .equ    ILLINOIS, 1
        .equ    PEGASUS, 2
        .equ    ANDERSON_BJORCK, 3
        .ifdef  HISTORICAL
        .equ    FALSI, PAPER
        .endif
        .ifndef FALSI
        .equ    FALSI, PEGASUS
        .endif

; After FALSI_STEPS steps of falsi a bracket is bisected at most HALVINGS times.
        .equ    FALSI_STEPS, 20
        .equ    HALVINGS, 100

        .equ    QUARTIC_CONSTANTS, 15

        .macro  quartic_constants
        .word   1.0, 0.5, 1.5, 3.0, 4.0
        .word   2.0                     ; a bracket with a greater ratio of its
                                        ; ends is bisected in the exponent
        .word   X'FFA6 4000 0000 0000'  ; tolerance 2^-44: |f| counts as 0 up to
                                        ; this share of the sum of |c_i| |t|^i
        .word   X'FFA9 4000 0000 0000'  ; closeness 2^-41: the final length of a
                                        ; bracket, relative to |t|
        .word   X'FFB6 4000 0000 0000'  ; 2^-28: closeness of a knot; it changes
                                        ; f by at most 2^-56 of its terms
        .word   X'FFB8 4000 0000 0000'  ; 2^-26: a longer Newton step does not
                                        ; polish a knot
        .word   0.875                   ; smallest step, in units of closeness
        .word   1e30                    ; value for no root
        .word   1, FALSI_STEPS, FALSI_STEPS + HALVINGS  ; integers
        .endm
