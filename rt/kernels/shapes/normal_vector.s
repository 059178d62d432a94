; normal_vector.s - the normals at m points of one primitive: what all of the
; files normal_.._vector.s have in common.
;
; In:  [qx] [qy] [qz], the points in the shape's own space; the record.
; Out: [nx] [ny] [nz], in that space, of length one, pointing outwards.
; Source: textbook; which face or side is decided by the least distance.
; Uses v0-v7, hits0-hits3.

        .share  phase
        .regs   r185, qx, qy, qz            ; point
        .endshare

        .macro  look_at_points x0, x1, x2
        RTOR    \x0, qx
        RTOR    \x1, qy
        RTOR    \x2, qz
        .endm
