; pattern_vector.s - computes the colours of patterns at m points.  The formulas
; are in pattern.s.

        .share  scratch
        .reg    link_pattern, r248
        .reg    link_sine, r249
        .endshare
        .share  shape
        .regs   r40, turn, per_turn, sin15, quarter, eighth, wrap, unwrap
        .regs   r47, two_thirds, per_root3, third, three
        .endshare

; [x] := [x] - floor([x]).  Changes work.
        .macro  less_floor x, work
        FLRV    [\x], [\work]
        ADDNV   [\work], r0, [\work]
        SUBNV   [\x], [\work], [\x]
        .endm

        .macro  not_below_0 x
        CMPLTV  [\x], r0, [hits1]
        VTOV    r0, [\x] ? [hits1]
        .endm

        .macro  greater_of x, y
        CMPLTV  [\x], [\y], [hits1]
        VTOV    [\y], [\x] ? [hits1]
        .endm

        .macro  pattern_axis k0, k1, k2, k3, q
        dot_constant px, py, pz, \k0, \k1, \k2, \q, v0
        ADDNV   [\q], \k3, [\q]
        .endm

        .kernel shade
; In:  px py pz; m00 .. = P_PATTERN, map_function .. = P_MAP or the map of the
;      sky.
; Out: cr cg cb.  Changes v0-v7, hits1-hits3.
find_pattern:
        RTOR    link_inner, link_pattern
        pattern_axis m00, m01, m02, m03, v5
        pattern_axis m10, m11, m12, m13, v6
        pattern_axis m20, m21, m22, m23, v7
; find_value is called by BSAVE link_pattern.  If there are no stops, it returns
; the values v0 of the points v5 v6 v7.
find_value:
        EX      s0, pattern_constants
        ELEN    s0, PATTERN_CONSTANTS
        SWAP    [s0], turn, [r0]
        RTOR    map_function, target
        BSAVE   link_inner, [target]
        IBXEQ   map_wave, r0, r0, pattern_found
        CFPEQ   map_a, r0, pattern_wave
        LINKV
        MPYSV   [v0], map_a, [v0]
        ADDNV   [v0], map_b, [v0]
        MPYSV   [v0], unwrap, [v1]
        TRUV    [v1], [v1]
        ADDNV   [v1], r0, [v1]
        LINKV
        MPYSV   [v1], wrap, [v1]
        SUBNV   [v0], [v1], [v0]
pattern_wave:
        FLRV    [v0], [v1]
        ADDNV   [v1], r0, [v1]
        CMPLTV  [v1], r0, [hits1]
        SUBNV   [v0], [v1], [v0] ? [hits1]
        RTOR    map_wave, target
        BSAVE   link_inner, [target]            ; continues at pattern_found
wave_ramp:
pattern_found:
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

wave_triangle:
        MPYSV   [v0], two, [v0]
        CMPLTV  one, [v0], [hits1]
        SUBNV   two, [v0], [v0] ? [hits1]
        BIM     pattern_found
wave_sine:
        EX      target, find_sine
        BSAVE   link_sine, [target]
        LINKV
        ADDNV   [v0], one, [v0]
        MPYSV   [v0], half, [v0]
        BIM     pattern_found
wave_scallop:
        MPYSV   [v0], half, [v0]
        EX      target, find_sine
        BSAVE   link_sine, [target]
        ABSV    [v0], [v0]
        BIM     pattern_found
wave_cubic:
        MPYSV   [v0], [v0], [v1]
        LINKV
        MPYSV   [v0], two, [v0]
        SUBNV   three, [v0], [v0]
        MPYSV   [v0], [v1], [v0]
        BIM     pattern_found
wave_poly:
        CMPLTV  [v0], tiny, [hits1]
        VTOV    tiny, [v0] ? [hits1]
        RTOR    map_c, exponent
        EX      target, power
        BSAVE   link_inner, [target]
        BIM     pattern_found

; [v0] = sin(2 pi [v0]).  Changes v1-v4, hits1; called by BSAVE link_sine.
find_sine:
        ADDNV   [v0], half, [v1]
        FLRV    [v1], [v1]
        ADDNV   [v1], r0, [v1]
        SUBNV   [v0], [v1], [v2]
        ABSV    [v2], [v3]
        SUBNV   half, [v3], [v4]
        CMPLTV  quarter, [v3], [hits1]
        VTOV    [v4], [v3] ? [hits1]
        CMPLTV  [v2], r0, [hits1]
        VTOV    -[v3], [v3] ? [hits1]
        MPYSV   [v3], turn, [v2]
        MPYSV   [v2], [v2], [v3]
        VTOV    -[v3], [v3]
        horner_start v3, sin15, exp13
        horner  v3, exp11
        horner  v3, exp9
        horner  v3, exp7
        horner  v3, exp5
        horner  v3, exp3
        horner  v3, one
        MPYSV   [v0], [v2], [v0]
        BIM     0, link_sine

; The routines of the functions: In: v5 v6 v7 = x, y, z.  Out: v0.
pattern_planar:
        ABSV    [v6], [v0]
pattern_within:
        SUBNV   one, [v0], [v0]
        not_below_0 v0
        BIM     0, link_inner
pattern_spherical:
        dot_vectors v5, v6, v7, v5, v6, v7, v0, v1
        SQRTV   [v0], [v0]
        BIM     pattern_within
pattern_cylindrical:
        MPYSV   [v5], [v5], [v0]
        MPYSV   [v7], [v7], [v1]
        ADDNV   [v1], [v0], [v0]
        SQRTV   [v0], [v0]
        BIM     pattern_within
pattern_boxed:
        ABSV    [v5], [v0]
        ABSV    [v6], [v1]
        greater_of v0, v1
        ABSV    [v7], [v1]
        greater_of v0, v1
        BIM     pattern_within
pattern_onion:
        dot_vectors v5, v6, v7, v5, v6, v7, v0, v1
        SQRTV   [v0], [v0]
        less_floor v0, v1
        BIM     0, link_inner
pattern_gradient:
        VTOV    [v5], [v0]
        FLRV    [v0], [v1]
        ADDNV   [v1], r0, [v1]
        not_below_0 v1
        SUBNV   [v0], [v1], [v0]
        BIM     0, link_inner
pattern_leopard:
        MPYSV   [v5], per_turn, [v0]
        EX      target, find_sine
        BSAVE   link_sine, [target]
        VTOV    [v0], [v5]
        MPYSV   [v6], per_turn, [v0]
        BSAVE   link_sine, [target]
        ADDNV   [v0], [v5], [v5]
        MPYSV   [v7], per_turn, [v0]
        BSAVE   link_sine, [target]
        LINKV
        ADDNV   [v0], [v5], [v0]
        MPYSV   [v0], third, [v0]
        MPYSV   [v0], [v0], [v0]
        BIM     0, link_inner

; a = the smaller of |x| and |z| over the greater, from 0 to 1.
pattern_radial:
        ABSV    [v5], [v0]
        ABSV    [v7], [v1]
        CMPLTV  [v1], [v0], [hits2]             ; |x| is greater
        VTOV    [v0], [v2]
        VTOV    [v1], [v0] ? [hits2]
        VTOV    [v2], [v1] ? [hits2]
        CMPEQV  [v1], r0, [hits1]
        VTOV    one, [v1] ? [hits1]             ; on the axis
        DIVSV   [v0], [v1], [v0]
        SUBNV   [v0], one, [v1]
        ADDNV   [v0], one, [v2]
        CMPLTV  eighth, [v0], [hits1]
        DIVSV   [v1], [v2], [v2]
        VTOV    [v2], [v0] ? [hits1]
        VTOV    [v0], [v2]
        MPYSV   [v2], [v2], [v3]
        VTOV    -[v3], [v3]
        log_series v3, one
        MPYSV   [v0], [v2], [v0]
        MPYSV   [v0], per_turn, [v0]
        MPYS    quarter, half, s0
        ADDNV   [v0], s0, [v0] ? [hits1]
        SUBNV   quarter, [v0], [v0] ? [hits2]
        CMPLTV  [v7], r0, [hits1]
        SUBNV   half, [v0], [v0] ? [hits1]
        CMPLTV  [v5], r0, [hits1]
        VTOV    -[v0], [v0] ? [hits1]
        ADDN    half, quarter, s0
        ADDNV   [v0], s0, [v0]
        BIM     0, link_inner

; [hits1] = mortar: {[q] per + shift} <= mortar per.
        .macro  mortar q, per, shift
        MPYSV   [\q], \per, [v1]
        ADDNV   [v1], \shift, [v1]
        less_floor v1, v2
        MPYS    map_d, \per, s0
        CMPGEV  s0, [v1], [hits1]
        .endm

pattern_brick:
        ADDN    map_d, checker_shift, s0
        ADDNV   [v5], s0, [v5]
        ADDNV   [v6], s0, [v6]
        ADDNV   [v7], s0, [v7]
        MPYSV   [v6], map_b, [v3]
        VTOV    [v3], [v1]
        less_floor v1, v2
        MPYS    map_d, map_b, s0
        VTOV    one, [v0]
        CMPGEV  s0, [v1], [hits1]
        VTOV    r0, [v0] ? [hits1]
        MPYSV   [v3], half, [v3]
        less_floor v3, v2
        CMPGEV  half, [v3], [hits2]             ; s = 0
        MASKV   r0, half, [v4] ? [hits2]
        mortar  v5, map_a, [v4]
        VTOV    r0, [v0] ? [hits1]
        SUBNV   half, [v4], [v4]
        mortar  v7, map_c, [v4]
        VTOV    r0, [v0] ? [hits1]
        BIM     0, link_inner

        .macro  nearest_whole x, whole, away
        ADDNV   [\x], half, [\whole]
        FLRV    [\whole], [\whole]
        ADDNV   [\whole], r0, [\whole]
        SUBNV   [\whole], [\x], [\away]
        ABSV    [\away], [\away]
        .endm

pattern_hexagon:
        MPYSV   [v5], two_thirds, [v5]          ; k
        MPYSV   [v7], per_root3, [v7]
        LINKV
        MPYSV   [v5], half, [v1]
        SUBNV   [v7], [v1], [v7]                ; a
        ADDNV   [v5], [v7], [v6]
        nearest_whole v5, v0, v2
        nearest_whole v7, v1, v3
        nearest_whole v6, v4, v5                ; k + a
        CMPLTV  [v3], [v2], [hits1]
        CMPLTV  [v5], [v2], [hits2]
        ANDB    [hits1], [hits2], [hits1]       ; k changes most
        CMPGEV  [v3], [v2], [hits2]
        CMPLTV  [v5], [v3], [hits3]
        ANDB    [hits2], [hits3], [hits2]       ; a changes most
        SUBNV   [v4], [v1], [v2]
        VTOV    [v2], [v0] ? [hits1]
        SUBNV   [v4], [v0], [v2]
        VTOV    [v2], [v1] ? [hits2]
        SUBNV   [v1], [v0], [v0]
        MPYSV   [v0], third, [v1]
        ADDNV   [v1], checker_shift, [v1]
        FLRV    [v1], [v1]
        ADDNV   [v1], r0, [v1]
        LINKV
        MPYSV   [v1], three, [v1]
        SUBNV   [v0], [v1], [v0]
        MPYSV   [v0], half, [v0]
        BIM     0, link_inner

        .if     BUMPS
        .macro  cell_floor q, whole
        ADDNV   [\q], checker_shift, [\whole]
        FLRV    [\whole], [\whole]
        .endm

pattern_checker:
        cell_floor v5, v0
        cell_floor v6, v1
        cell_floor v7, v2
        ADDUV   [v0], [v1], [v0]
        LINKV
        ADDUV   [v0], [v2], [v0]
        ANDV    [v0], one_index, [v1]
        CMPNEV  [v1], r0, [hits1]
        VTOV    r0, [v0]
        VTOV    one, [v0] ? [hits1]
        BIM     0, link_inner
        .endif
        .endkernel
