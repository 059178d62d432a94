; normal_blob.s - computes the normal of a blob (normal_vector.s).
;
; The normal is opposite to the gradient of the field.  The matrix M leads to
; the space of a component.  There P is relative to the nearest point of its
; axis, if it has one:
;
;   g = 1 - P . P        S g^2 falls fastest along  S g M^T P,   if g > 0

        .kernel shade
        .if     BLOB_PIECES
; Adds a component's part: strength sh0, length of the axis sh1, matrix
; sh2-sh13.
        .macro  take_part
        dot_numbers t0, t1, t2, sh10, sh11, sh12, t5, t6
        dot_numbers t0, t1, t2, sh2, sh3, sh4, t3, t6
        raise   t5, sh13, t5
        dot_numbers t0, t1, t2, sh6, sh7, sh8, t4, t6
        copy    t5, t7
        lower   t5, sh1, t5
        raise   t3, sh5, t3
        raise   t4, sh9, t4
        not_below_number m_zero, t5
        if_less_number t7, r0, part_on_axis\@
        then_copy t7, t5
        end_if  part_on_axis\@
        dot_product t3, t4, t5, t3, t4, t5, t6, t7
        from    m_one, t6, t6                   ; g
        if_number_less r0, t6, part_outside\@
        scale   t6, sh0, t6
        three_by times, t6, t3, t4, t5, t3, t4, t5
        dot_numbers t3, t4, t5, sh2, sh6, sh10, t6, t7
        then_plus nx, t6, nx
        dot_numbers t3, t4, t5, sh3, sh7, sh11, t6, t7
        then_plus ny, t6, ny
        dot_numbers t3, t4, t5, sh4, sh8, sh12, t6, t7
        then_plus nz, t6, nz
        end_if  part_outside\@
        .endm

normal_blob:
        load_shape 6
        three   lower, qx, qy, qz, sh0, sh1, sh2, t0, t1, t2
        RTOR    sh5, spare
        clear   nx
        clear   ny
        clear   nz
        load_field P_TABLE, table
        IX      table, 64 * BLOB_STRENGTH
normal_blob_row:
        load_from table, 14, sh0
        IX      table, 64 * BLOB_SIZE
        take_part
        SUBN    spare, m_one, spare
        CFPLT   r0, spare, normal_blob_row
        BIM     gradient_normal
        .endif
        .endkernel
