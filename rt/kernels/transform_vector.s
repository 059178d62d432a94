; transform_vector.s - a primitive that stands in a space of its own.
;
; Its kernel sees the queue's rays carried into that space by the matrix M
; (P_LOCAL):  O' = M O + m,  D' = M D / s,  s = |M D|.  The distances it finds
; are s times too long, and are multiplied by lscale = 1/s where the ray hit.
; What counts there is beyond s tmin; a little more, so that what lies beyond
; that lies beyond tmin here, too.
;
; In:  ox oy oz dx dy dz lower (world), n long; the primitive's record.
; Out: tin, tout (world); ox .. lower name the world's rays again.
; Source: textbook; D' is of length one again, as the kernels ask for.

        .kernel transform
transformed:
        load_record P_LOCAL, 12, m00
        dot_constant wox, woy, woz, m00, m01, m02, lox, w0
        ADDNV   [lox], m03, [lox]
        dot_constant wox, woy, woz, m10, m11, m12, loy, w0
        ADDNV   [loy], m13, [loy]
        dot_constant wox, woy, woz, m20, m21, m22, loz, w0
        ADDNV   [loz], m23, [loz]
        dot_constant wdx, wdy, wdz, m00, m01, m02, ldx, w0
        dot_constant wdx, wdy, wdz, m10, m11, m12, ldy, w0
        dot_constant wdx, wdy, wdz, m20, m21, m22, ldz, w0
        normalise ldx, ldy, ldz, w0, lscale
        EX      s0, k_lower
        LOD     [s0], s0
        MPYSV   [w0], s0, [llower]
        look_at_rays lox, loy, loz, ldx, ldy, ldz, llower
        RTOR    link_kernel, link_inner
        load_field P_INNER, target
        BSAVE   link_kernel, [target]
        RTOR    link_inner, link_kernel
        CMPGEV  [tout], [tin], [bits0]
        MPYSV   [tin], [lscale], [tin] ? [bits0]
        MPYSV   [tout], [lscale], [tout] ? [bits0]
        look_at_rays wox, woy, woz, wdx, wdy, wdz, wlower
        BIM     0, link_kernel
        .endkernel
