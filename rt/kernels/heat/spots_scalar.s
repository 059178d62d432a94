; spots_scalar.s - the points of spots.s, one after another.

        .regs   r30, spot_i, spot_number, spot_t, spot_d, spot_o

        .macro  spots_axis
        ES      spot_i, 0
spots_word\@:
        LOD     [spot_line, spot_i], spot_number
        LOD     [spot_distance, spot_i], spot_t
        LOD     [spot_direction, spot_number], spot_d
        LOD     [spot_origin, spot_number], spot_o
        MPYS    spot_t, spot_d, spot_t
        ADDN    spot_o, spot_t, spot_t
        STO     [result_ray, spot_i], spot_d
        STO     [result_spot, spot_i], spot_t
        LOD     [spot_normal, spot_i], spot_o
        SUBN    r0, spot_o, spot_o
        STO     [result_face, spot_i], spot_o
        IBXNE   spot_i, spot_one, spot_count, spots_word\@, spot_i
        .endm

        .kernel spots
spots:
        spots_begin
        spots_axis
        spots_next
        spots_axis
        spots_next
        spots_axis
        ES      spot_i, 0
spots_weigh:
        STO     [result_weight, spot_i], spot_weight
        IBXNE   spot_i, spot_one, spot_count, spots_weigh, spot_i
        EXIT
        .endkernel
