; pigment.s - colours of pigments, in both forms.
;
; Checker: the second colour where floor(x) + floor(y) + floor(z) is odd in the
; pigment's space.  Gradient: the coordinate along an axis, minus its floor, is
; a position between the stops of a map; the colour is interpolated linearly
; between two stops.
; Source: POV-Ray's gradient and its colour maps.

; q = a coordinate of the point in the space of a pigment or shape.
        .macro  local_coordinate k0, k1, k2, k3, q, work=t0
        dot_numbers px, py, pz, \k0, \k1, \k2, \q, \work
        raise   \q, \k3, \q
        .endm

        .macro  coordinate_floor k0, k1, k2, k3, sum
        local_coordinate \k0, \k1, \k2, \k3, t0, t1
        raise   t0, m_checker_shift, t0
        floor   t0, \sum
        .endm

; t2 + t4 is odd in the cells with the second colour.
        .macro  checker_floors
        load_record P_PATTERN, 12, m00
        coordinate_floor m00, m01, m02, m03, t2
        coordinate_floor m10, m11, m12, m13, t3
        coordinate_floor m20, m21, m22, m23, t4
        plus_index t2, t3, t2
        .endm

; t0 = the value of the gradient, from 0 to 1.
        .macro  gradient_value
        local_coordinate m00, m01, m02, m03, t0, t1
        floor   t0, t1
        normal  t1, t1
        minus   t0, t1, t0
        .endm

; t1 = the position of the value t0 between a stop and the one after it, 0 to 1.
        .macro  place_between_stops
        lowered_scale t0, stop_at, stop_scale, t1
        .endm

        .macro  colour_between_stops
        place_between_stops
        line_three t1, rise_r, stop_r, cr, t1, rise_g, stop_g, cg, t1, rise_b, stop_b, cb
        .endm

        .macro  pattern_point
        local_coordinate m00, m01, m02, m03, q_x
        local_coordinate m10, m11, m12, m13, q_y
        local_coordinate m20, m21, m22, m23, q_z
        .endm
