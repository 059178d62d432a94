; normal_quartic_vector.s - computes the normals of quartic surfaces
; (normal_vector.s).

        .kernel shade
; The normal is the gradient of F, whose terms are grouped as in
; quartic_terms.s.  For each row B (v0; its derivative by z in v1), each group A
; (v2; by y in v3, by z in v4) and F (v5; its gradient in n) Horner's rule is
;
;   value := value x + c,    derivative := derivative x + value before
        .macro  gradient_step c, x, work
        MPYSV   [\c], [\x], [\c]
        ADDNV   [\work], [\c], [\c]
        .endm

; Adds a term to the row; c is its coefficient, one of the words from sh0 on.
        .macro  gradient_term c
        gradient_step v1, qz, v0
        LINKV
        MPYSV   [v0], [qz], [v0]
        ADDNV   [v0], \c, [v0]
        .endm

        .macro  gradient_row first
        VTOV    \first, [v0]
        VTOV    r0, [v1]
        .endm

        .macro  gradient_group_row
        gradient_step v3, qy, v2
        gradient_step v2, qy, v0
        gradient_step v4, qy, v1
        .endm

        .macro  gradient_group words
        ELEN    table_at, \words
        SWAP    [table_at], sh0, [r0]
        IX      table_at, 64 * \words
        VTOV    sh0, [v2]
        VTOV    r0, [v3]
        VTOV    r0, [v4]
        gradient_rows \words
        gradient_step nx, qx, v5
        gradient_step v5, qx, v2
        gradient_step ny, qx, v3
        gradient_step nz, qx, v4
        .endm

normal_quartic:
        load_field P_TABLE, table_at
        VTOV    r0, [nx]
        VTOV    r0, [ny]
        VTOV    r0, [nz]
        VTOV    r0, [v5]
        gradient_group 1
        gradient_group 3
        gradient_group 6
        gradient_group 10
        gradient_group 15
        BIM     gradient_normal
        .endkernel
