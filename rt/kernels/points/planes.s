; planes.s - the form of a program: scalar if the constant SCALAR is defined,
; otherwise vector.

        .ifndef planes.s
        .equ    planes.s, 1

; A program that is written by hand in each form.
        .macro  by_hand program
        .ifdef  SCALAR
        .include "\program\()_scalar.s"
        .else
        .include "\program\()_vector.s"
        .endif
        .endm

        .endif
