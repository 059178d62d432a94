; normal_quartic.s - computes the normal of a quartic surface (normal_vector.s).
;
; The normal is the gradient of F, whose terms are grouped as in
; quartic.s.  For each row B (t0; its derivative by z in t1), each group A
; (t2; by y in t3, by z in t4) and F (t5; its gradient in n) Horner's rule is
;
;   value := value x + c,    derivative := derivative x + value before

        .kernel shade
        .macro  gradient_row first, second
        set     \first, t0
        set     m_zero, t1
        derivative_step qz, \second, t0, t1
        .endm

; Adds the row to the group.
        .macro  gradient_row_end
        times   t3, qy, t3
        times   t2, qy, t6
        times   t4, qy, t4
        plus    t2, t3, t3
        plus    t0, t6, t2
        plus    t1, t4, t4
        .endm

        .macro  gradient_group words
        load_from table, \words, sh0
        IX      table, 64 * \words
        set     sh0, t2
        set     m_zero, t3
        set     m_zero, t4
        .if     \words >= 3
        gradient_row sh1, sh2
        gradient_row_end
        .endif
        .if     \words >= 6
        gradient_row sh3, sh4
        derivative_step qz, sh5, t0, t1
        gradient_row_end
        .endif
        .if     \words >= 10
        gradient_row sh6, sh7
        derivative_step qz, sh8, t0, t1
        derivative_step qz, sh9, t0, t1
        gradient_row_end
        .endif
        .if     \words >= 15
        gradient_row sh10, sh11
        derivative_step qz, sh12, t0, t1
        derivative_step qz, sh13, t0, t1
        derivative_step qz, sh14, t0, t1
        gradient_row_end
        .endif
        times   nx, qx, nx
        times   t5, qx, t6
        times   ny, qx, ny
        times   nz, qx, nz
        plus    t5, nx, nx
        plus    t2, t6, t5
        plus    t3, ny, ny
        plus    t4, nz, nz
        .endm

normal_quartic:
        load_field P_TABLE, table
        set     m_zero, nx
        set     m_zero, ny
        set     m_zero, nz
        set     m_zero, t5
        gradient_group 1
        gradient_group 3
        gradient_group 6
        gradient_group 10
        gradient_group 15
        BIM     gradient_normal
        .endkernel
