; spots_vector.s - the points of spots.s, all at once.

        .regs   r30, v_line, v_distance, v_spot, v_ray, v_temp, v_plane

        .macro  as_vector plane, vector
        ADDLEN  \plane, spot_count, \vector
        .endm

        .macro  spots_axis
        as_vector result_ray, v_ray
        as_vector result_spot, v_spot
        VXTOV   [v_line], [spot_direction], [v_ray]
        VXTOV   [v_line], [spot_origin], [v_temp]
        MPYSV   [v_distance], [v_ray], [v_spot]
        ADDNV   [v_temp], [v_spot], [v_spot]
        as_vector spot_normal, v_plane
        as_vector result_face, v_spot
        SUBNV   r0, [v_plane], [v_spot]
        .endm

        .kernel spots
spots:
        spots_begin
        as_vector spot_line, v_line
        as_vector spot_distance, v_distance
        as_vector result_weight, v_temp
        spots_axis
        spots_next
        spots_axis
        spots_next
        spots_axis
        VTOV    spot_weight, [v_temp]
        EXIT
        .endkernel
