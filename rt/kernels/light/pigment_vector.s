; pigment_vector.s - the colours of a primitive at m points.
;
; Checker: the second colour where floor(x) + floor(y) + floor(z) is odd, in
; the pigment's space.
;
; In:  px py pz; the primitive's record.
; find_pigment: cr cg cb.  find_checker: hits3, where the second colour is;
; uses v0-v4.

        .share  scratch
        .regs   r248, color0r, color0g, color0b, color1r, color1g, color1b
        .endshare

        .macro  pattern_floor x0, x1, x2, k0, k1, k2, k3, sum
        dot_constant \x0, \x1, \x2, \k0, \k1, \k2, v0, v1
        ADDNV   [v0], \k3, [v0]
        ADDNV   [v0], checker_shift, [v0]
        FLRV    [v0], [\sum]
        .endm

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
        load_field P_CHECKER, s0
        IBXEQ   s0, r0, r0, pigment_plain
        EX      target, find_checker
        BSAVE   link_inner, [target]
        VTOV    color1r, [cr] ? [hits3]
        VTOV    color1g, [cg] ? [hits3]
        VTOV    color1b, [cb] ? [hits3]
pigment_plain:
        BIM     0, link_kernel
        .endkernel
