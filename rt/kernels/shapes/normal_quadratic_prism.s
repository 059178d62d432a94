; normal_quadratic_prism.s - computes the normal of a prism of quadratic splines
; (normal_vector.s).
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
        .share  normals
        .regs   row0, foot_x, foot_z, bow_x, bow_z, path_x, path_z, share_x, share_z
        .regs   row8, curve_outward, curve_begins, curve_at
        .endshare

; t0 = the smallest square of a distance so far.
        .macro  take_curve
        lower   qx, foot_x, t1
        lower   qz, foot_z, t2
        scale   t1, share_x, t3
        scaled_plus t2, share_z, t3, t3
        not_below_number m_zero, t3             ; w
        not_above_number m_one, t3
        line_two t3, bow_x, path_x, t4, t3, bow_z, path_z, t5
        times   t4, t3, t6
        times   t5, t3, t7
        minus   t1, t6, t6
        minus   t2, t7, t7
        times   t6, t6, t6
        times   t7, t7, t7
        plus    t7, t6, t6
        if_less t6, t0, curve_farther\@
        skip_if_none curve_none\@
        then_copy t6, t0
        scaled_plus t3, bow_z, t5, t6
        scaled_plus t3, bow_x, t4, t7
        then_scale t6, curve_outward, nx
        then_set m_zero, ny
        SUBN    m_zero, curve_outward, curve_outward
        then_scale t7, curve_outward, nz
        end_if  curve_farther\@
curve_none\@:
        .endm

        begin_normals quadratic_prism
normal_curve:
        address_of table, QUADRATIC_BEGINS, curve_at
        LOD     [curve_at], curve_begins
        CFPNE   curve_begins, r0, normal_curve_next
        IX      curve_at, 64 * (QUADRATIC_FOOT - QUADRATIC_BEGINS)
        load_from curve_at, 9, foot_x           ; foot_x .. curve_outward
        take_curve
normal_curve_next:
        IX      table, 64 * QUADRATIC_SIZE
        SUBN    sh2, m_one, sh2
        CFPLT   r0, sh2, normal_curve
        BIM     gradient_normal
        .endkernel
        .endif
