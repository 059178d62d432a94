; normal_scalar.s - the normal at one point of a primitive: what all of the files
; normal_.._scalar.s have in common; see normal_vector.s.  They are parts of the
; subroutine SHADE, which branches to them by normal_link: point in qx qy qz,
; normal in nx ny nz; uses t0-t6.

        .macro  load_shape number
        RTOR    a_primitive, t0
        IX      t0, 64 * P_SHAPE
        ELEN    t0, \number
        SWAP    [t0], sh0, [r0]
        .endm
