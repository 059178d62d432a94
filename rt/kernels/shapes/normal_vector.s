; normal_vector.s - computes the normals at m points of one primitive: the part
; that all normal_.._vector.s files share.
;
; In:  [qx] [qy] [qz], the points in the shape's own space; the record.
; Out: [nx] [ny] [nz], in that space, of length one, pointing outwards.
; Source: textbook; the nearest face or side is the one that a point belongs to.
; Changes v0-v7, hits0-hits3.

        .share  phase
        .regs   r185, qx, qy, qz            ; point
        .endshare

        .macro  set_points x0, x1, x2
        RTOR    \x0, qx
        RTOR    \x1, qy
        RTOR    \x2, qz
        .endm
