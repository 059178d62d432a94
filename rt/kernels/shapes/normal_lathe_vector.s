; normal_lathe_vector.s - computes the normals of lathes (normal_vector.s).
;
; A point at distance rho from the axis belongs to the segment that is nearest
; in r and y, as in normal_prism.s.  A segment goes from a corner (r, y)
; back to the previous one.  With its direction u, length l and outward normal
; n:
;
;   along = (rho - r, Y - y) . u    across = (rho - r, Y - y) . n
;   distance^2 = across^2 + max(along - l, 0)^2 + min(along, 0)^2
;   N = (nr X / rho, ny, nr Z / rho);  on the axis X / rho is 1.
;
; A segment counts only if it is nearer than a thousandth of the lathe's size.
; Segments whose heights are farther than that from those of all points are
; skipped.

        .if     LATHES
        .kernel shade
        .share  shape
        .regs   r46, foot_height, foot_begins, foot_low, foot_high
        .regs   r50, foot_radius, back_r, back_y, back_length, outward_r
        .regs   r55, outward_y
        .endshare

; [v0] = the smallest square of a distance so far, [v6] = rho, [v7] = Y.
        .macro  take_segment
        nearest_edge v6, v7, foot_radius, foot_height, back_r, back_y, back_length, outward_r, outward_y, none
        then_set outward_r, nx
        then_set outward_y, ny
        .endm

normal_lathe:
        load_record P_SHAPE, 7, sh0
        RTOR    sh3, s2
        MPYSV   [qx], [qx], [v6]
        MPYSV   [qz], [qz], [v1]
        ADDNV   [v1], [v6], [v6]
        SQRTV   [v6], [v6]
        SUBNV   [qy], sh0, [v7]
        VTOV    sh5, [v0]
        VTOV    one, [nx]
        VTOV    r0, [ny]
        MINV    [v7], s0, s3
        MAXV    [v7], s0, s4
        SUBN    s3, sh6, s3
        ADDN    s4, sh6, s4
        load_field P_TABLE, s1
        IX      s1, 64 * LATHE_HEIGHT
normal_lathe_row:
        ELEN    s1, 4
        SWAP    [s1], foot_height, [r0]         ; foot_height .. foot_high
        CFPNE   foot_begins, r0, normal_lathe_next
        CFPLT   foot_high, s3, normal_lathe_next
        CFPLT   s4, foot_low, normal_lathe_next
        RTOR    s1, s0
        IX      s0, 64 * (LATHE_RADIUS - LATHE_HEIGHT)
        ELEN    s0, 6
        SWAP    [s0], foot_radius, [r0]         ; foot_radius .. outward_y
        take_segment
normal_lathe_next:
        IX      s1, 64 * LATHE_SIZE
        SUBN    s2, one, s2
        CFPLT   r0, s2, normal_lathe_row
        CMPEQV  [v6], r0, [hits0]
        VTOV    one, [v6] ? [hits0]
        MASKV   one, [qx], [v1] ? [hits0]
        DIVSV   [nx], [v6], [v2]
        MPYSV   [v1], [v2], [nx]
        MPYSV   [qz], [v2], [nz]
        BIM     0, link_kernel
        .endkernel
        .endif
