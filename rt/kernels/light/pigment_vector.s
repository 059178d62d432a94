; pigment_vector.s - computes the colours of a primitive at m points
; (pigment.s).
;
; In:  px py pz; the primitive's record; for find_gradient the words of
;      P_PATTERN or scene_sky in m00 .. m11.
; find_pigment, find_gradient: Out: cr cg cb.  find_checker: Out: hits3 = the
; points with the second colour.  They change v0-v4, hits3.

        .share  scratch
        .regs   r248, color0r, color0g, color0b, color1r, color1g, color1b
        .endshare

        .share  shape
        .regs   sh0, stop_at, stop_scale, stop_r, stop_g, stop_b, rise_r, rise_g
        .reg    rise_b, sh7
        .endshare

        .macro  next_stop
        load_from s9, STOP_SIZE, stop_at
        IX      s9, 64 * STOP_SIZE
        .endm

; Computes a channel of the colours in hits3.
        .macro  channel_after_stop rise, stop, color
        LINKV
        MPYSV   [v1], \rise, [v2]
        ADDNV   [v2], \stop, [\color] ? [hits3]
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

; In:  px py pz; m00 .. = P_PATTERN, map_function .. = P_MAP or the map of the
;      sky.
; Out: cr cg cb.  Changes v0-v7, hits1-hits3.
; find_value is called by BSAVE link_pattern.  If there are no stops, it returns
; the values v0 of the points v5 v6 v7.
        .macro  begin_pattern
find_pattern:
        RTOR    link_inner, link_pattern
        pattern_point
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
        checker_floors
        LINKV
        ADDXV   [v2], [v4], [v2]
        ANDV    [v2], one_index, [v2]
        CMPNEV  [v2], r0, [hits3]
        BIM     0, link_inner

find_pigment:
        load_record P_COLOR, 6, color0r
        copy_three color0r, color0g, color0b, [cr], [cg], [cb], VTOV
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
        gradient_value
find_colours:                                   ; values v0, map m10, m11
        RTOR    m10, s9
        next_stop
        colour_between_stops
gradient_next:
        next_stop
        place_between_stops
        CMPGEV  [v0], stop_at, [hits3]
        channel_after_stop rise_r, stop_r, cr
        channel_after_stop rise_g, stop_g, cg
        channel_after_stop rise_b, stop_b, cb
        IBXNE   m11, minus_one_index, r0, gradient_next, m11
        BIM     0, link_inner
        .endkernel
