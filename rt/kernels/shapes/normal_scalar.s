; normal_scalar.s - the scalar form of the normals: the macros that all
; normal_NAME.s files share.  They are parts of the subroutine SHADE, which
; branches to them with normal_link.  The point is in qx, qy, qz, the normal in
; nx, ny, nz; t0-t6 change (normal_vector.s).

        .reg    table, here
        .reg    spare, t8
        .share  local
        .regs   r96, row0, row1, row2, row3, row4, row5, row6, row7, row8, row9
        .regs   r106, row10, row11, row12, row13, row14, row15, row16, row17
        .regs   r114, point_s, point_t
        .endshare

        .macro  matrix_times x0, x1, x2, y0, y1, y2
        matrix_rows \x0, \x1, \x2, \y0, \y1, \y2, t3, t4, t5, t6
        .endm

; The parameters of the hit on a patch.
        .macro  load_point_s
        load_field P_PATCH_POINT, point_s
        .endm

        .macro  load_point_t
        load_field P_PATCH_POINT + 1, point_t
        .endm

; a = the greatest number, at the start of a search for the smallest.
        .macro  set_big a
        EX      \a, k_big
        LOD     [\a], \a
        .endm

; The extremes of a.
        .macro  least_of a, c
        RTOR    \a, \c
        .endm

        .macro  greatest_of a, c
        RTOR    \a, \c
        .endm

; Branches to label if the condition is false for all points.
        no_code skip_if_none

        .macro  leave_normal
        BIM     0, normal_link
        .endm

; Leaves the normal, and continues with the points for which the condition of
; label is false.
        .macro  leave_or label
        leave_normal
\label:
        .endm
