; hits_vector.s - the test of hits.s: a queue of rays against each cylinder.
;
; It uses 14 vectors. Seven of them hold the rays and the results.

        .regs   r32, ox, oy, oz, dx, dy, dz, v_results
        .regs   r39, v0, v1, v2, v3, v4, v5, v6
        .regs   r46, u0, u1, u2, u3, u4, u5, u6         ; of the near rays
        .regs   r53, b_hit, b_near, b_ok, b_one, b_other, b_none
        .regs   r59, hit_n, hit_m, hit_o, hit_zero

        .data
        .align  64
hits_store:     .space 7 * QUEUE
hits_bits:      .space (QUEUE + 63) / 64 * 6
        .code

        .macro  hits_bit bits, number, count
        EX      \bits, hits_bits + (QUEUE + 63) / 64 * 64 * (\number)
        ADDLEN  \bits, \count, \bits
        .endm

        .macro  hits_plane address, vector
        ADDLEN  \address, hit_n, \vector
        ADDX    \address, hit_stride, \address
        .endm

; Computes a vector times the constant axis, as a sum of three products.
; Overwrites [w].
        .macro  dot_axis x, y, z, result, w
        MPYSV   [\x], cyl_ax, [\result]
        LINKV
        MPYSV   [\y], cyl_ay, [\w]
        ADDNV   [\w], [\result], [\result]
        LINKV
        MPYSV   [\z], cyl_az, [\w]
        ADDNV   [\w], [\result], [\result]
        .endm

; [result] := [result] - [x] [y]. Overwrites [w].
        .macro  less_product x, y, result, w
        MPYSV   [\x], [\y], [\w]
        SUBNV   [\result], [\w], [\result]
        .endm

        .macro  sum_products ax, ay, az, bx, by, bz, result, w
        MPYSV   [\ax], [\bx], [\result]
        MPYSV   [\ay], [\by], [\w]
        ADDNV   [\w], [\result], [\result]
        MPYSV   [\az], [\bz], [\w]
        ADDNV   [\w], [\result], [\result]
        .endm

; Excludes rays for which both conditions hold.
        .macro  unless_both
        ANDB    [b_one], [b_other], [b_one]
        ANDNB   [b_ok], [b_one], [b_ok]
        .endm

        .kernel hits
hits:
        hits_begin
        ES      hit_zero, 0
hits_next:
        IBXEQ   hit_rays, r0, r0, hits_done
        EX      hit_n, QUEUE
        IBXLE   hit_n, r0, hit_rays, hits_full
        RTOR    hit_rays, hit_n
hits_full:
        RTOR    hit_from, hit_work
        hits_plane hit_work, ox
        hits_plane hit_work, oy
        hits_plane hit_work, oz
        RTOR    hit_towards, hit_work
        hits_plane hit_work, dx
        hits_plane hit_work, dy
        hits_plane hit_work, dz
        ADDLEN  hit_results, hit_n, v_results
        EX      hit_work, hits_store
        .rept   7
        ADDLEN  hit_work, hit_n, v\+
        IX      hit_work, 64 * QUEUE
        .endr
        hits_bit b_hit, 0, hit_n
        hits_bit b_near, 1, hit_n
        XORB    [b_hit], [b_hit], [b_hit]
        RTOR    hit_list, hit_at
        RTOR    hit_cylinders, hit_left

hits_cylinder:
        load_cylinder
        SUBNV   [ox], cyl_x, [v0]
        SUBNV   [oy], cyl_y, [v1]
        SUBNV   [oz], cyl_z, [v2]
        dot_axis v0, v1, v2, v3, v4                     ; b
        dot_axis dx, dy, dz, v4, v5                     ; a
        sum_products v0, v1, v2, dx, dy, dz, v5, v6
        less_product v4, v3, v5, v6                     ; p
        MPYSV   [v0], [v0], [v0]
        MPYSV   [v1], [v1], [v1]
        ADDNV   [v1], [v0], [v0]
        MPYSV   [v2], [v2], [v2]
        ADDNV   [v2], [v0], [v0]
        less_product v3, v3, v0, v6
        SUBNV   [v0], cyl_square, [v0]                  ; q
        MPYSV   [v4], [v4], [v1]
        SUBNV   hit_unit, [v1], [v1]                    ; g
        MPYSV   [v5], [v5], [v2]
        less_product v1, v0, v2, v6                     ; s^2
        CMPGEV  [v2], r0, [b_near]
        CNTOB   [b_near], hit_m
        IBXEQ   hit_m, r0, r0, hits_passed

; Compresses g, s^2, b, a, p to the near rays.
        SUBX    hit_n, hit_m, hit_o
        EX      hit_work, hits_store
        .rept   7
        ADDLEN  hit_work, hit_m, u\+
        IX      hit_work, 64 * QUEUE
        .endr
        hits_bit b_ok, 2, hit_m
        hits_bit b_one, 3, hit_m
        hits_bit b_other, 4, hit_m
        hits_bit b_none, 5, hit_o
        CPSV    [v1], [u0] ? [b_near]
        CPSV    [v2], [u1] ? [b_near]
        CPSV    [v3], [u2] ? [b_near]
        CPSV    [v4], [u3] ? [b_near]
        CPSV    [v5], [u4] ? [b_near]
        SQRTV   [u1], [u1]                              ; s
        SUBNV   [u1], [u4], [u5]                        ; the last g t
        ADDNV   [u4], [u1], [u6]
        SUBNV   r0, [u6], [u6]                          ; the first, or 0
        CMPLTV  [u6], r0, [b_one]
        VTOV    r0, [u6] ? [b_one]
        CMPLTV  r0, [u5], [b_ok]
        MPYSV   [u2], [u0], [u2]
        MPYSV   [u0], cyl_length, [u0]
        MPYSV   [u6], [u3], [u6]
        ADDNV   [u2], [u6], [u6]                        ; g h at both
        MPYSV   [u5], [u3], [u5]
        ADDNV   [u2], [u5], [u5]
        CMPLTV  [u6], r0, [b_one]
        CMPLTV  [u5], r0, [b_other]
        unless_both
        CMPLTV  [u0], [u6], [b_one]
        CMPLTV  [u0], [u5], [b_other]
        unless_both
        hits_bit b_other, 4, hit_n
        MRGB    [b_ok], [b_none], [b_other] ? [b_near]
        ORB     [b_hit], [b_other], [b_hit]
hits_passed:
        IBXNE   hit_left, hit_minus_one, r0, hits_cylinder, hit_left

        VTOV    hit_zero, [v_results]
        VTOV    hit_one, [v_results] ? [b_hit]
        SHIFTI  hit_n, 6, hit_work
        ADDX    hit_from, hit_work, hit_from
        ADDX    hit_towards, hit_work, hit_towards
        ADDX    hit_results, hit_work, hit_results
        SUBX    hit_rays, hit_n, hit_rays
        BIM     hits_next
hits_done:
        EXIT
        .endkernel
