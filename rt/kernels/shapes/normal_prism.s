; normal_prism.s - computes the normal of a prism (normal_vector.s).
;
; A point belongs to the nearest cap or edge, seen along y.  An edge goes from a
; corner P back to the previous one.  With its direction u, length l and outward
; normal n:
;
;   along = (X - P) . u    across = (X - P) . n
;   distance^2 = across^2 + max(along - l, 0)^2 + min(along, 0)^2

        .kernel shade

; t0 = the smallest square of a distance so far.  Lowers it to that of the edge;
; begins a case, up to end_if farther, of the points to which the edge is
; nearer.
        .macro  nearest_edge x, z, foot_x, foot_z, back_x, back_z, length, out_x, out_z, farther
        lower   \x, \foot_x, t1
        lower   \z, \foot_z, t2
        scaled_plus_scaled_two t1, \back_x, t2, \back_z, t3, t1, \out_x, t2, \out_z, t4
        times   t4, t4, t4                      ; the square of across
        lower   t3, \length, t5
        if_number_less r0, t5, edge_begins\@
        times   t5, t5, t5
        then_plus t4, t5, t4
        end_if  edge_begins\@
        if_less_number t3, r0, edge_square\@
        times   t3, t3, t3
        then_plus t4, t3, t4
        end_if  edge_square\@
        if_less t4, t0, \farther
        then_copy t4, t0
        .endm

        .macro  take_edge
        nearest_edge qx, qz, sh3, sh4, sh6, sh7, sh8, sh9, sh10, edge_farther\@
        then_set sh9, nx
        then_set m_zero, ny
        then_set sh10, nz
        end_if  edge_farther\@
        .endm

; Sets the normal of the nearer of the caps at y = sh0 and y = sh1; t0 = the
; square of its distance.
        .macro  nearest_cap
        lower   qy, sh0, t0
        lower   qy, sh1, t1
        times   t0, t0, t0
        times   t1, t1, t1
        set     m_zero, nx
        set     m_minus_one, ny
        if_less t1, t0, cap_nearest\@
        then_copy t1, t0
        then_set m_one, ny
        end_if  cap_nearest\@
        .endm

; Begins the normals of a prism, with or without caps.
        .macro  begin_normals name
normal_open_\name:
        load_shape 3
        set_big t0
        set     m_one, nx
        set     m_zero, ny
        BIM     normal_\name\()_sides
normal_\name:
        load_shape 3
        nearest_cap
normal_\name\()_sides:
        set     m_zero, nz
        load_field P_TABLE, table
        .endm

        begin_normals prism
normal_prism_row:
        load_from table, PRISM_SIZE, sh3
        IX      table, 64 * PRISM_SIZE
        CFPNE   sh5, r0, normal_prism_next
        take_edge
normal_prism_next:
        SUBN    sh2, m_one, sh2
        CFPLT   r0, sh2, normal_prism_row
        leave_normal
        .endkernel
