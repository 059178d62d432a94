; hits.s - tests whether rays hit any of some solid cylinders.
;
; The scalar form tests each ray against cylinders up to a hit, the vector form
; each cylinder against a queue of rays.
;
; A cylinder has the radius r and the axis C + h A with 0 <= h <= L and |A| = 1.
; The ray is O + t D, |D| = 1. Let W = O - C:
;
;   b = W . A     a = D . A               along the axis
;   p = W . D - a b,  q = W . W - b^2 - r^2,  g = 1 - a^2
;
; Across the axis the ray is inside where g t^2 + 2 p t + q <= 0. It is never
; inside if p^2 - g q < 0. Otherwise it is inside for g t from -p - s to -p + s,
; where s is the square root of p^2 - g q. It hits if, for some g t >= 0 of
; these, the height h is between 0 and L. Then g h = g b + a (g t) is between 0
; and g L. As h is linear in t, this fails only if g h is below 0 at both ends,
; or above g L at both. There is no division. A ray along the axis, g = 0, is a
; miss.
;
; In:  the words below.
; Out: hits_results, for each ray 1: it hits one, 0: it hits none.
; Source: derived here; "it is only of interest knowing that the ray strikes the
; tube and not where": Plunkett, Cychosz and Bailey 1984.

        .include "points/planes.s"

        .record CYLINDER
        .field  CYLINDER_BASE, 3
        .field  CYLINDER_AXIS, 3
        .field  CYLINDER_LENGTH
        .field  CYLINDER_SQUARE         ; r^2
        .endrecord

        .data
hits_arguments:
hits_rays:      .word 0                 ; number of rays, an integer
hits_from:      .word 0                 ; address of the planes of O: x, y, z
hits_towards:   .word 0                 ; address of the planes of D
hits_cylinders: .word 0                 ; cylinders, 1 or more, an integer
hits_list:      .word 0                 ; address of their records
hits_results:   .word 0                 ; address of a plane
                .word 1, -1
                .word 1.0
                .equ    HITS_ARGUMENTS, 9
        .code

        .regs   r10, hit_rays, hit_from, hit_towards, hit_cylinders, hit_list, hit_results
        .regs   r16, hit_one, hit_minus_one, hit_unit
        .regs   r19, hit_stride         ; bits between planes
        .regs   r20, cyl_x, cyl_y, cyl_z, cyl_ax, cyl_ay, cyl_az, cyl_length, cyl_square
        .regs   r28, hit_at, hit_left, hit_work
        .regs   r32, ox, oy, oz, dx, dy, dz
        .regs   r39, s0, s1, s2, s3, s4, s5, s6

; result = result - x y
        .macro  less_product x, y, result
        times   \x, \y, s6
        minus   \result, s6, \result
        .endm

        .ifdef  SCALAR
        .regs   s0, first, g, square, b, a, p, last
        .reg    hit_reported, r46
        scalar_form

; The dot product of x, y, z and the axis. It changes w.
        .macro  dot_axis x, y, z, result, w
        MPYS    \x, cyl_ax, \result
        MPYS    \y, cyl_ay, \w
        ADDN    \w, \result, \result
        MPYS    \z, cyl_az, \w
        ADDN    \w, \result, \result
        .endm

        .macro  next_rays
        .endm

        .macro  load_plane address, register
        LOD     [\address], \register
        ADDX    \address, hit_stride, \address
        .endm

        .macro  begin_tests
        ES      hit_reported, 0
        .endm

; Branch to `passed` if s^2 < 0, if all g t are below 0, or if both g h are
; below 0 or both above g L.
        .macro  keep_near passed
        CFPLT   square, r0, \passed
        .endm

        .macro  keep_last passed
        CFPGE   r0, last, \passed
        .endm

        .macro  keep_heights passed
        CFPGE   first, r0, hits_high
        CFPLT   last, r0, \passed
hits_high:
        CFPGE   g, first, hits_struck
        CFPLT   g, last, \passed
hits_struck:
        .endm

; The first hit of a ray ends its tests.
        .macro  report
        RTOR    hit_one, hit_reported
        BIM     hits_reported
        .endm

        .macro  store_hits
        STO     [hit_results], hit_reported
        IX      hit_from, 64
        IX      hit_towards, 64
        IX      hit_results, 64
        IBXNE   hit_rays, hit_minus_one, r0, hits_next, hit_rays
        .endm

        .else
; The vector form uses 14 vectors. Seven of them hold the rays and the results.
        .reg    v_results, r38
        .regs   r46, g, square, b, a, p, last, first    ; of the near rays
        .regs   g, near0, near1, near2, near3, near4, near5, near6
        .regs   r53, b_hit, b_near, b_ok, b_one, b_other, b_none
        .regs   r59, hit_n, hit_m, hit_o, hit_zero
        vector_form , b_one

        .data
        .align  64
hits_store:     .space 7 * QUEUE
hits_bits:      .space (QUEUE + 63) / 64 * 6
        .code

        .macro  hits_bit bits, number, count
        describe \bits, hits_bits + (QUEUE + 63) / 64 * 64 * (\number), \count
        .endm

        .macro  dot_axis x, y, z, result, w
        MPYSV   [\x], cyl_ax, [\result]
        scaled_plus \y, cyl_ay, \result, \result
        scaled_plus \z, cyl_az, \result, \result
        .endm

        .macro  next_rays
        at_most QUEUE, hit_rays, hit_n
        .endm

        .macro  load_plane address, vector
        ADDLEN  \address, hit_n, \vector
        ADDX    \address, hit_stride, \address
        .endm

        .macro  begin_tests
        ADDLEN  hit_results, hit_n, v_results
        EX      hit_work, hits_store
        .rept   7
        ADDLEN  hit_work, hit_n, s\+
        IX      hit_work, 64 * QUEUE
        .endr
        hits_bit b_hit, 0, hit_n
        hits_bit b_near, 1, hit_n
        XORB    [b_hit], [b_hit], [b_hit]
        .endm

; Compresses g, s^2, b, a and p to the near rays.
        .macro  keep_near passed
        CMPGEV  [s2], r0, [b_near]
        if_none b_near, hit_m, \passed
        SUBX    hit_n, hit_m, hit_o
        EX      hit_work, hits_store
        .rept   7
        ADDLEN  hit_work, hit_m, near\+
        IX      hit_work, 64 * QUEUE
        .endr
        hits_bit b_ok, 2, hit_m
        hits_bit b_one, 3, hit_m
        hits_bit b_other, 4, hit_m
        hits_bit b_none, 5, hit_o
        CPSV    [s1], [g] ? [b_near]
        CPSV    [s2], [square] ? [b_near]
        CPSV    [s3], [b] ? [b_near]
        CPSV    [s4], [a] ? [b_near]
        CPSV    [s5], [p] ? [b_near]
        .endm

; Excludes rays from [b_ok] by the other conditions of the scalar form.
        .macro  keep_last passed
        CMPLTV  r0, [last], [b_ok]
        .endm

        .macro  keep_heights passed
        CMPLTV  [first], r0, [b_one]
        keep_where CMPLTV, [last], r0, b_one, b_other
        ANDNB   [b_ok], [b_one], [b_ok]
        CMPLTV  [g], [first], [b_one]
        keep_where CMPLTV, [g], [last], b_one, b_other
        ANDNB   [b_ok], [b_one], [b_ok]
        .endm

        .macro  report
        hits_bit b_other, 4, hit_n
        MRGB    [b_ok], [b_none], [b_other] ? [b_near]
        ORB     [b_hit], [b_other], [b_hit]
        .endm

        .macro  store_hits
        VTOV    hit_zero, [v_results]
        VTOV    hit_one, [v_results] ? [b_hit]
        SHIFTI  hit_n, 6, hit_work
        ADDX    hit_from, hit_work, hit_from
        ADDX    hit_towards, hit_work, hit_towards
        ADDX    hit_results, hit_work, hit_results
        SUBX    hit_rays, hit_n, hit_rays
        BIM     hits_next
        .endm
        .endif

        .entry  hits
        .kernel hits
hits:
        load_words hits_arguments, HITS_ARGUMENTS, hit_rays, hit_work
        SHIFTI  hit_rays, 6, hit_stride
        .ifndef SCALAR
        ES      hit_zero, 0
        .endif
hits_next:
        IBXEQ   hit_rays, r0, r0, hits_done
        next_rays
        RTOR    hit_from, hit_work
        load_plane hit_work, ox
        load_plane hit_work, oy
        load_plane hit_work, oz
        RTOR    hit_towards, hit_work
        load_plane hit_work, dx
        load_plane hit_work, dy
        load_plane hit_work, dz
        begin_tests
        RTOR    hit_list, hit_at
        RTOR    hit_cylinders, hit_left

hits_cylinder:
        load_from hit_at, CYLINDER_SIZE, cyl_x
        IX      hit_at, 64 * CYLINDER_SIZE
        three   lower, ox, oy, oz, cyl_x, cyl_y, cyl_z, s0, s1, s2
        dot_axis s0, s1, s2, s3, s4                     ; b
        dot_axis dx, dy, dz, s4, s5                     ; a
        times   s0, dx, s5
        times   s1, dy, s6
        plus    s6, s5, s5
        times   s2, dz, s6
        plus    s6, s5, s5
        less_product s4, s3, s5                         ; p
        times   s0, s0, s0
        times   s1, s1, s1
        plus    s1, s0, s0
        times   s2, s2, s2
        plus    s2, s0, s0
        less_product s3, s3, s0
        lower   s0, cyl_square, s0                      ; q
        times   s4, s4, s1
        from    hit_unit, s1, s1                        ; g
        times   s5, s5, s2
        less_product s1, s0, s2                         ; s^2
        keep_near hits_passed

        root    square, square                          ; s
        minus   square, p, last                         ; the last g t
        keep_last hits_passed
        plus    p, square, first
        from    r0, first, first                        ; the first, or 0
        if_less_number first, r0, hits_first
        then_set r0, first
        end_if  hits_first
        times   b, g, b
        scale   g, cyl_length, g
        times   first, a, first
        plus    b, first, first                         ; g h at both
        times   last, a, last
        plus    b, last, last
        keep_heights hits_passed
        report
hits_passed:
        IBXNE   hit_left, hit_minus_one, r0, hits_cylinder, hit_left
hits_reported:
        store_hits
hits_done:
        EXIT
        .endkernel
