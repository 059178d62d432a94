; area_vector.s - computes the light of an area light that reaches the hits of a
; queue.
;
; From the hits that face the light, rays go to each point of its area, one
; queue per point (shadow_vector.s).  They end at the point, and not k_shadow
; before it as rays to a light without an area (POV-Ray's rule).  A point in the
; dark adds nothing.
;
; If a point of the light equals a hit, nothing is between them and the
; direction is arbitrary; x is used.  With an indefinite direction the scalar
; form would search for the next crossing of a transparent body without end.
;
; In:  hits3, light_at, light_beam; px ..
; Out: hit_tint_store = the transmitted light; tinted = 1; lx .., ndotl as for
;      the light's own position; ndotl = 0 except in hits3.
; Source: beam.s.

        .data
area_at:        .word 0                 ; the next point; the number left
                .word 0
area_link:      .word 0
        .align  64
area_store:     .space 3 * QUEUE        ; sum of the light, for all hits
        .code

; work = the address of the points of light_beam.  Branches to none if it has no
; area.
        .macro  area_of_light work, none
        IBXEQ   light_beam, r0, r0, \none
        load_of light_beam, BEAM_POINTS, \work
        IBXEQ   \work, r0, r0, \none
        .endm

        .macro  area_channel into, number
        describe \into, area_store + 64 * QUEUE * \number, h
        .endm

        .macro  area_begin number
        area_channel s0, \number
        VTOV    r0, [s0]
        .endm

; Adds the weight of the point, times the transmitted light, where it is not
; dark.
        .macro  area_add light, number
        area_channel s0, \number
        MPYSV   [ndotl], \light, [v1]
        ADDNV   [s0], [v1], [s0]
        .endm

        .macro  area_end number
        area_channel s0, \number
        describe s1, hit_tint_store + 64 * QUEUE * \number, h
        VTOV    [s0], [s1]
        .endm

; lx, ly, lz = the directions from the hits to a point.
        .macro  area_direction x, y, z
        three   SUBNV, \x, \y, \z, [px], [py], [pz], [lx], [ly], [lz]
        normalise lx, ly, lz, v0, v1
        .endm

        .kernel shadow
cast_from_area:
        store_word link, area_link, shape_at
        address_of light_beam, BEAM_POINTS, s0
        ELEN    s0, 2
        EX      s1, area_at
        ELEN    s1, 2
        SWAP    [s0], s2, [r0]
        SWAP    [r0], s2, [s1]
        area_begin 0
        area_begin 1
        area_begin 2
cast_from_point:
        load_word area_at, shadows
        RTOR    shadows, s3
        load_from s3, LIGHT_POINT_SIZE, s4
        area_direction s4, s5, s6
        CMPEQV  [v0], r0, [hits1]
        if_none hits1, s0, cast_to_point
        VTOV    one, [lx] ? [hits1]
        VTOV    r0, [ly] ? [hits1]
        VTOV    r0, [lz] ? [hits1]
cast_to_point:
        VTOV    s7, [ndotl]
        CNTOB   [hits3], s8
        ES      tinted, 0
        call_routine cast_shadows, link
        IBXNE   tinted, r0, r0, area_tinted
        area_add light_r, 0
        area_add light_g, 1
        area_add light_b, 2
        BIM     area_next
area_tinted:
        area_add [tint_r], 0
        area_add [tint_g], 1
        area_add [tint_b], 2
area_next:
        EX      s0, area_at
        load_from s0, 2, s2
        IX      s2, 64 * LIGHT_POINT_SIZE
        IX      s3, -1
        SWAP    [r0], s2, [s0]
        IBXNE   s3, r0, r0, cast_from_point
        area_end 0
        area_end 1
        area_end 2
        ES      tinted, 1
        area_direction light_x, light_y, light_z
        dot_vectors nx, ny, nz, lx, ly, lz, ndotl, v1
        VTOV    r0, [ndotl] ?! [hits3]
        load_word area_link, s0
        BIM     0, s0
        .endkernel
