; pigment_vector.s - computes the colours of a primitive at m points.
;
; Checker: the second colour where floor(x) + floor(y) + floor(z) is odd in the
; pigment's space.  Gradient: the coordinate along an axis, minus its floor, is
; a position between the stops of a map; the colour is interpolated linearly
; between two stops.
;
; In:  px py pz; the primitive's record; for find_gradient the words of
;      P_PATTERN or scene_sky in m00 .. m11.
; find_pigment, find_gradient: Out: cr cg cb.  find_checker: Out: hits3 = the
; points with the second colour.  They change v0-v4, hits3.
; Source: POV-Ray's gradient and its colour maps.

        .share  scratch
        .regs   r248, color0r, color0g, color0b, color1r, color1g, color1b
        .endshare

        .macro  pattern_floor x0, x1, x2, k0, k1, k2, k3, sum
        dot_constant \x0, \x1, \x2, \k0, \k1, \k2, v0, v1
        ADDNV   [v0], \k3, [v0]
        ADDNV   [v0], checker_shift, [v0]
        FLRV    [v0], [\sum]
        .endm

; Loads the next stop, sh0 .. sh7.  [v1] = the position of the values between it
; and the one after it, 0 to 1.
        .macro  next_stop
        load_from s9, STOP_SIZE, sh0
        IX      s9, 64 * STOP_SIZE
        LINKV
        SUBNV   [v0], sh0, [v1]
        MPYSV   [v1], sh1, [v1]
        .endm

        .if     PATTERNS
        .share  scratch
        .reg    link_pattern, r248
        .reg    sine_link, r249
        .endshare
        .share  shape
        .regs   r40, turn, per_turn, quarter, eighth, wrap, unwrap
        .regs   r46, two_thirds, per_root3, third_part, three
        .regs   r50, angle3, angle5, angle7, angle9, angle11, angle13, angle15
        .reg    angle17, r57
        .endshare
        .share  patterns
        .regs   s0, number, none
        .endshare

        .macro  pattern_axis k0, k1, k2, k3, q
        dot_constant px, py, pz, \k0, \k1, \k2, \q, v0
        ADDNV   [\q], \k3, [\q]
        .endm

; In:  px py pz; m00 .. = P_PATTERN, map_function .. = P_MAP or the map of the
;      sky.
; Out: cr cg cb.  Changes v0-v7, hits1-hits3.
; find_value is called by BSAVE link_pattern.  If there are no stops, it returns
; the values v0 of the points v5 v6 v7.
        .macro  begin_pattern
find_pattern:
        RTOR    link_inner, link_pattern
        pattern_axis m00, m01, m02, m03, q_x
        pattern_axis m10, m11, m12, m13, q_y
        pattern_axis m20, m21, m22, m23, q_z
        .endm

        .macro  end_pattern
        .if     BUMPS
        IBXEQ   map_stop_count, r0, r0, pattern_value
        .endif
        RTOR    map_stops, m10
        RTOR    map_stop_count, m11
        RTOR    link_pattern, link_inner
        BIM     find_colours
        .if     BUMPS
pattern_value:
        BIM     0, link_pattern
        .endif
        .endm

        .macro  return_wave
        BIM     pattern_found
        .endm

        .macro  raise_value to
        RTOR    \to, exponent
        call_routine power, link_inner
        .endm
        .endif

        .kernel shade
find_checker:
        load_record P_PATTERN, 12, m00
        pattern_floor px, py, pz, m00, m01, m02, m03, v2
        pattern_floor px, py, pz, m10, m11, m12, m13, v3
        pattern_floor px, py, pz, m20, m21, m22, m23, v4
        ADDUV   [v2], [v3], [v2]
        LINKV
        ADDUV   [v2], [v4], [v2]
        ANDV    [v2], one_index, [v2]
        CMPNEV  [v2], r0, [hits3]
        BIM     0, link_inner

find_pigment:
        load_record P_COLOR, 6, color0r
        VTOV    color0r, [cr]
        VTOV    color0g, [cg]
        VTOV    color0b, [cb]
        load_field P_PIGMENT, s0
        IBXEQ   s0, r0, r0, pigment_plain
        IBXNE   s0, r0, one_index, pigment_gradient
        call_routine find_checker, link_inner
        VTOV    color1r, [cr] ? [hits3]
        VTOV    color1g, [cg] ? [hits3]
        VTOV    color1b, [cb] ? [hits3]
pigment_plain:
        BIM     0, link_kernel

pigment_gradient:
        .if     PATTERNS
        ES      s1, 2
        IBXNE   s0, r0, s1, pigment_pattern
        .endif
        load_record P_PATTERN, 6, m00
        call_routine find_gradient, link_inner
        BIM     0, link_kernel

        .if     PATTERNS
pigment_pattern:
        load_record P_PATTERN, 12, m00
        load_record P_MAP, MAP_SIZE, map_function
        call_routine find_pattern, link_inner
        BIM     0, link_kernel
        .endif

find_gradient:
        dot_constant px, py, pz, m00, m01, m02, v0, v1
        ADDNV   [v0], m03, [v0]
        FLRV    [v0], [v1]
        ADDNV   [v1], r0, [v1]
        SUBNV   [v0], [v1], [v0]
find_colours:                                   ; values v0, map m10, m11
        RTOR    m10, s9
        next_stop
        LINKV
        MPYSV   [v1], sh5, [cr]
        ADDNV   [cr], sh2, [cr]
        LINKV
        MPYSV   [v1], sh6, [cg]
        ADDNV   [cg], sh3, [cg]
        LINKV
        MPYSV   [v1], sh7, [cb]
        ADDNV   [cb], sh4, [cb]
gradient_next:
        next_stop
        CMPGEV  [v0], sh0, [hits3]
        LINKV
        MPYSV   [v1], sh5, [v2]
        ADDNV   [v2], sh2, [cr] ? [hits3]
        LINKV
        MPYSV   [v1], sh6, [v2]
        ADDNV   [v2], sh3, [cg] ? [hits3]
        LINKV
        MPYSV   [v1], sh7, [v2]
        ADDNV   [v2], sh4, [cb] ? [hits3]
        IBXNE   m11, minus_one_index, r0, gradient_next, m11
        BIM     0, link_inner
        .endkernel
