; hits_scalar.s - the test of hits.s: each ray against cylinders up to a hit.

        .regs   r32, ox, oy, oz, dx, dy, dz
        .regs   r39, s0, s1, s2, s3, s4, s5, s6
        .regs   r46, hit_reported

        .macro  load_plane address, register
        LOD     [\address], \register
        ADDX    \address, hit_stride, \address
        .endm

; The operations and their order are those of the vector form.
        .macro  dot_axis x, y, z, result, w
        MPYS    \x, cyl_ax, \result
        MPYS    \y, cyl_ay, \w
        ADDN    \w, \result, \result
        MPYS    \z, cyl_az, \w
        ADDN    \w, \result, \result
        .endm

        .macro  less_product x, y, result, w
        MPYS    \x, \y, \w
        SUBN    \result, \w, \result
        .endm

        .kernel hits
hits:
        hits_begin
hits_next:
        IBXEQ   hit_rays, r0, r0, hits_done
        RTOR    hit_from, hit_work
        load_plane hit_work, ox
        load_plane hit_work, oy
        load_plane hit_work, oz
        RTOR    hit_towards, hit_work
        load_plane hit_work, dx
        load_plane hit_work, dy
        load_plane hit_work, dz
        RTOR    hit_list, hit_at
        RTOR    hit_cylinders, hit_left
        ES      hit_reported, 0

hits_cylinder:
        load_cylinder
        SUBN    ox, cyl_x, s0
        SUBN    oy, cyl_y, s1
        SUBN    oz, cyl_z, s2
        dot_axis s0, s1, s2, s3, s4                     ; b
        dot_axis dx, dy, dz, s4, s5                     ; a
        MPYS    s0, dx, s5
        MPYS    s1, dy, s6
        ADDN    s6, s5, s5
        MPYS    s2, dz, s6
        ADDN    s6, s5, s5
        less_product s4, s3, s5, s6                     ; p
        MPYS    s0, s0, s0
        MPYS    s1, s1, s1
        ADDN    s1, s0, s0
        MPYS    s2, s2, s2
        ADDN    s2, s0, s0
        less_product s3, s3, s0, s6
        SUBN    s0, cyl_square, s0                      ; q
        MPYS    s4, s4, s1
        SUBN    hit_unit, s1, s1                        ; g
        MPYS    s5, s5, s2
        less_product s1, s0, s2, s6                     ; s^2
        CFPLT   s2, r0, hits_passed
        SQRT    s2, s2                                  ; s
        SUBN    s2, s5, s6                              ; the last g t
        CFPGE   r0, s6, hits_passed
        ADDN    s5, s2, s0
        SUBN    r0, s0, s0                              ; the first, or 0
        CFPGE   s0, r0, hits_first
        RTOR    r0, s0
hits_first:
        MPYS    s3, s1, s3
        MPYS    s1, cyl_length, s1
        MPYS    s0, s4, s0
        ADDN    s3, s0, s0                              ; g h at both
        MPYS    s6, s4, s6
        ADDN    s3, s6, s6
        CFPGE   s0, r0, hits_high
        CFPLT   s6, r0, hits_passed
hits_high:
        CFPGE   s1, s0, hits_struck
        CFPLT   s1, s6, hits_passed
hits_struck:
        RTOR    hit_one, hit_reported
        BIM     hits_reported
hits_passed:
        IBXNE   hit_left, hit_minus_one, r0, hits_cylinder, hit_left
hits_reported:
        STO     [hit_results], hit_reported
        IX      hit_from, 64
        IX      hit_towards, 64
        IX      hit_results, 64
        IBXNE   hit_rays, hit_minus_one, r0, hits_next, hit_rays
hits_done:
        EXIT
        .endkernel
