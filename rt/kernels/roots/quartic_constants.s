; quartic_constants.s - what both forms of the root solver share: the rule of
; its falsi, its limits, and the numbers that stand in its registers.
;
; FALSI says what becomes of the value at the end of the bracket that is kept,
; when the new point X falls on the side of the newest end B; A is the other
; end.  Chosen when the program is assembled; the default by measured clocks
; (docs/quartic.md).
;
;   PAPER            f(A) is halved once A has been kept twice running.  The
;                    paper says no more than "Modified Regula Falsi"; this is
;                    the lightest change that keeps plain falsi from stalling.
;   ILLINOIS         f(A) is halved each time
;   PEGASUS          f(A) is multiplied by f(B) / (f(B) + f(X))
;   ANDERSON_BJORCK  by 1 - f(X) / f(B), where that is above 0; else halved
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

; After so many steps of falsi the bracket is halved, so many times at most.
        .equ    FALSI_STEPS, 20
        .equ    HALVINGS, 100

        .equ    QUARTIC_CONSTANTS, 15

        .macro  quartic_constants
        .word   1.0, 0.5, 1.5, 3.0, 4.0
        .word   2.0                     ; wider than that a bracket is halved
                                        ; in the exponent
        .word   X'FFA6 4000 0000 0000'  ; tolerance 2^-44: |f| as small beside
                                        ; the sum of |c_i| |t|^i is 0
        .word   X'FFA9 4000 0000 0000'  ; closeness 2^-41: so much of |t| may
                                        ; a bracket be long in the end
        .word   X'FFB6 4000 0000 0000'  ; 2^-28: that of a knot; it moves f by
                                        ; 2^-56 of its terms at most
        .word   X'FFB8 4000 0000 0000'  ; 2^-26: a longer step of Newton's does
                                        ; not polish a knot
        .word   0.875                   ; of the closeness, the least step
        .word   1e30                    ; no root
        .word   1, FALSI_STEPS, FALSI_STEPS + HALVINGS  ; integers
        .endm
