; transform_vector.s - intersects a primitive in its object space.
;
; The kernel gets the current rays in object space, transformed by the matrix M
; (P_LOCAL):
;
;   O' = M O + m,  D' = M D / s,  s = |M D|
;
; The distances that it returns are s times too long, so all of them except big
; and minus_big are multiplied by lscale = 1/s. The least distance in object
; space is slightly more than s tmin, so that a hit beyond it is beyond tmin in
; world space. For neighbouring primitives in one space, rays are transformed
; once.
;
; In:  wox .. wdz, near long; the primitive's record; inner_kernel;
;      segments_wanted.
; Out: tin, tout and so on (world).
; Source: textbook. D' is normalised, as the kernels require.

        .macro  scale_back t
        CMPLTV  |[\t]|, big, [bits0]
        MPYSV   [\t], [lscale], [\t] ? [bits0]
        .endm

        .kernel transform
transformed:
        load_field P_SPACE, s9
        IBXEQ   s9, r0, space, transformed_shifted
        RTOR    s9, space
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
        .if     INTERIORS
        load_word passed_current, s0
        IBXNE   s0, r0, r0, transformed_passed
        .endif
        EX      s0, k_lower
        IBXEQ   shadows, r0, r0, transformed_least
        EX      s0, k_shadow_lower
transformed_least:
        LOD     [s0], s0
        MPYSV   [w0], s0, [llower]
transformed_shifted:
        set_rays lox, loy, loz, ldx, ldy, ldz, llower
        RTOR    link_kernel, link_inner
        BSAVE   link_kernel, [inner_kernel]
        RTOR    link_inner, link_kernel
        IBXEQ   segments_wanted, r0, one_index, transformed_segment
        scale_back tin
        scale_back tout
        scale_back tin2
        scale_back tout2
        ES      s0, 3
        IBXLT   segments_wanted, r0, s0, transformed_done
        scale_back tin3
        scale_back tout3
        .if     MAX_CROSSINGS > 6
        RTOR    tout3, s3
        ES      s0, -3
        ADDX    segments_wanted, s0, s2
transformed_more:
        IBXEQ   s2, r0, r0, transformed_done
        EX      s0, 64 * CROSSING_SIZE
        ADDX    s3, s0, s3
        scale_back s3
        ADDX    s3, s0, s3
        scale_back s3
        IBXNE   s2, minus_one_index, r0, transformed_more, s2
        .endif
transformed_done:
        BIM     0, link_kernel
        .if     INTERIORS
transformed_passed:
        EX      s0, 64 * QUEUE
        ADDX    wlower, s0, s0
        MPYSV   [w0], [s0], [llower]
        BIM     transformed_shifted
        .endif

; A single segment of any transformed shape is a miss or has two finite ends.
transformed_segment:
        CMPGEV  [tout], [tin], [bits0]
        MPYSV   [tin], [lscale], [tin] ? [bits0]
        MPYSV   [tout], [lscale], [tout] ? [bits0]
        BIM     0, link_kernel
        .endkernel
