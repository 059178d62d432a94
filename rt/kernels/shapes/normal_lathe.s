; normal_lathe.s - computes the normal of a lathe (normal_vector.s).
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
        .share  normals
        .regs   row0, foot_height, foot_begins, foot_low, foot_high
        .regs   row4, foot_radius, back_r, back_y, back_length, outward_r, outward_y
        .regs   row10, height_low, height_high, row_at
        .endshare

normal_lathe:
        load_shape 7
        RTOR    sh3, spare
        times   qx, qx, t6
        times   qz, qz, t1
        lower   qy, sh0, t7
        plus    t1, t6, t6
        root    t6, t6                          ; rho
        set     sh5, t0                         ; the smallest square so far
        set     m_one, nx
        set     m_zero, ny
        least_of t7, height_low
        greatest_of t7, height_high
        SUBN    height_low, sh6, height_low
        ADDN    height_high, sh6, height_high
        load_field P_TABLE, table
        IX      table, 64 * LATHE_HEIGHT
normal_lathe_row:
        load_from table, 4, foot_height         ; foot_height .. foot_high
        CFPNE   foot_begins, r0, normal_lathe_next
        CFPLT   foot_high, height_low, normal_lathe_next
        CFPLT   height_high, foot_low, normal_lathe_next
        load_part table, LATHE_RADIUS - LATHE_HEIGHT, 6, foot_radius, row_at ; .. outward_y
        nearest_edge t6, t7, foot_radius, foot_height, back_r, back_y, back_length, outward_r, outward_y, segment_farther
        then_set outward_r, nx
        then_set outward_y, ny
        end_if  segment_farther
normal_lathe_next:
        IX      table, 64 * LATHE_SIZE
        SUBN    spare, m_one, spare
        CFPLT   r0, spare, normal_lathe_row
        default qx, t1
        if_equal_number t6, r0, lathe_off_axis
        then_set_or_copy m_one, qx, t1
        then_set m_one, t6
        end_if  lathe_off_axis
        quotient nx, t6, t2
        times   t1, t2, nx
        times   qz, t2, nz
        leave_normal
        .endkernel
        .endif
