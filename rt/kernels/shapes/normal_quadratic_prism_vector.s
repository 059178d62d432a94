; normal_quadratic_prism_vector.s - computes the normals of prisms of quadratic
; splines (normal_vector.s).
;
; A point belongs to the nearest cap or parabola, seen along y.  On a parabola
; P + (bow w + way) w  the parameter w of its point X is linear:
; w = share . (X - P), because share is perpendicular to the bow.  So
;
;   w, clamped to 0 .. 1    distance = |X - P - (bow w + way) w|
;
; This is 0 on the parabola itself.  For any other it is at least the distance
; from the point to that parabola.  The normal is perpendicular to  2 bow w +
; way.

        .if     QUADRATIC_PRISMS
        .kernel shade
        .share  shape
        .regs   r43, curve_begins
        .regs   r44, foot_x, foot_z, bow_x, bow_z, path_x, path_z, share_x, share_z
        .regs   r52, curve_outward
        .endshare

; [slope] = bow w + way; [left_over] = from - slope w.
        .macro  along_curve bow, path, from, slope, left_over
        LINKV
        MPYSV   [v3], \bow, [\slope]
        ADDNV   [\slope], \path, [\slope]
        MPYSV   [\slope], [v3], [\left_over]
        SUBNV   [\from], [\left_over], [\left_over]
        .endm

; [v0] = the smallest square of a distance so far.
        .macro  take_curve
        SUBNV   [qx], foot_x, [v1]
        SUBNV   [qz], foot_z, [v2]
        MPYSV   [v1], share_x, [v3]
        LINKV
        MPYSV   [v2], share_z, [v4]
        ADDNV   [v4], [v3], [v3]
        CMPLTV  [v3], r0, [hits0]
        VTOV    r0, [v3] ? [hits0]
        CMPLTV  one, [v3], [hits0]
        VTOV    one, [v3] ? [hits0]
        along_curve bow_x, path_x, v1, v4, v6
        along_curve bow_z, path_z, v2, v5, v7
        MPYSV   [v6], [v6], [v6]
        MPYSV   [v7], [v7], [v7]
        ADDNV   [v7], [v6], [v6]
        CMPLTV  [v6], [v0], [hits0]
        CNTOB   [hits0], s0
        IBXEQ   s0, r0, r0, take_none\@
        VTOV    [v6], [v0] ? [hits0]
        LINKV
        MPYSV   [v3], bow_z, [v6]
        ADDNV   [v6], [v5], [v6]
        LINKV
        MPYSV   [v3], bow_x, [v7]
        ADDNV   [v7], [v4], [v7]
        MPYSV   [v6], curve_outward, [nx] ? [hits0]
        VTOV    r0, [ny] ? [hits0]
        SUBN    r0, curve_outward, s0
        MPYSV   [v7], s0, [nz] ? [hits0]
take_none\@:
        .endm

normal_open_quadratic_prism:
        load_record P_SHAPE, 3, sh0
        VTOV    big, [v0]
        VTOV    one, [nx]
        VTOV    r0, [ny]
        BIM     normal_curves
normal_quadratic_prism:
        load_record P_SHAPE, 3, sh0
        nearest_cap
normal_curves:
        VTOV    r0, [nz]
        load_field P_TABLE, s1
normal_curve:
        RTOR    s1, s0
        IX      s0, 64 * QUADRATIC_BEGINS
        LOD     [s0], curve_begins
        CFPNE   curve_begins, r0, normal_curve_next
        IX      s0, 64 * (QUADRATIC_FOOT - QUADRATIC_BEGINS)
        ELEN    s0, 9
        SWAP    [s0], foot_x, [r0]              ; foot_x .. curve_outward
        take_curve
normal_curve_next:
        IX      s1, 64 * QUADRATIC_SIZE
        SUBN    sh2, one, sh2
        CFPLT   r0, sh2, normal_curve
        BIM     gradient_normal
        .endkernel
        .endif
