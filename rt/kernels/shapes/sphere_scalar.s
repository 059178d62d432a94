; sphere_scalar.s - intersects one ray with a sphere.
;
;       CALL SPHERE (RAY, PRIMITIVE, SEGMENT)
;
; RAY = O, D (6 words, D of length one), then, for the kernels that use it, the
; lower limit of the distance.  PRIMITIVE = its record.  SEGMENT = tin, tout
; (2 words); a miss is big, minus_big.  The formulas and the order of the
; operations are those of sphere_vector.s, but a miss returns before the square
; root.

        shape_from r55                  ; after t6
        .equ    SPHERE_REGISTERS, 25

        .data
sphere_save:    .space SPHERE_REGISTERS
        .code
        .kernel sphere
sphere:
        enter_kernel sphere_save, SPHERE_REGISTERS, 4, index_one
        three   SUBN, sh0, sh1, sh2, ox, oy, oz, t0, t1, t2 ; L = C - O
        dot     t0, t1, t2, dx, dy, dz, t3, t4  ; b = L . D
        three_by MPYS, t3, dx, dy, dz, t4, t5, t6
        three   SUBN, t4, t5, t6, t0, t1, t2, t0, t1, t2 ; w = b D - L
        three   MPYS, t0, t1, t2, t0, t1, t2, t0, t1, t2
        ADDN    t1, t0, t0
        ADDN    t2, t0, t1
        SUBN    sh3, t1, t0             ; h = r^2 - w . w
        CFPGE   t0, r0, sphere_hit
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel index_one
sphere_hit:
        SQRT    t0, t0
        SUBN    t3, t0, tin
        ADDN    t3, t0, tout
        leave_kernel index_one
        .endkernel
