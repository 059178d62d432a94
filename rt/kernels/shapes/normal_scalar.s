; normal_scalar.s - the macro that all normal_.._scalar.s files share.  They are
; parts of the subroutine SHADE, which branches to them with normal_link.  The
; point is in qx, qy, qz, the normal in nx, ny, nz; t0-t6 change
; (normal_vector.s).

        .macro  load_shape number
        RTOR    a_primitive, t0
        IX      t0, 64 * P_SHAPE
        ELEN    t0, \number
        SWAP    [t0], sh0, [r0]
        .endm
