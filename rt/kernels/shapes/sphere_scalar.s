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
        SUBN    sh0, ox, t0             ; L = C - O
        SUBN    sh1, oy, t1
        SUBN    sh2, oz, t2
        dot     t0, t1, t2, dx, dy, dz, t3, t4  ; b = L . D
        MPYS    t3, dx, t4
        MPYS    t3, dy, t5
        MPYS    t3, dz, t6
        SUBN    t4, t0, t0              ; w = b D - L
        SUBN    t5, t1, t1
        SUBN    t6, t2, t2
        MPYS    t0, t0, t0
        MPYS    t1, t1, t1
        MPYS    t2, t2, t2
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
