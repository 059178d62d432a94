; rays_scalar.s - generates the rays of rays.s one by one.

        .regs   r71, ray_at, ray_p, ray_q, ray_x0, ray_x1
        .regs   r76, ray_y0, ray_y1, ray_y2, ray_y3, ray_y4

; Computes the words of the ray's point, ray_y0 and ray_y1.
        .macro  ray_words
        .if     POINTS == POINTS_RANDOM
        stream_words ray_state, ray_y\+, ray_work\+
        .else
        .if     POINTS == POINTS_GRID
        SHIFT   ray_point, ray_low, ray_work0
        MPYL    lattice_z0, ray_point, ray_y0
        MPYL    lattice_z1, ray_work0, ray_y1
        ADDX    ray_y0, lattice_shift0, ray_y0
        ADDX    ray_y1, lattice_shift1, ray_y1
        AND     ray_y0, lattice_mask, ray_y0
        AND     ray_y1, lattice_mask, ray_y1
        .else
        lattice_words ray_point, 2, ray_y\+
        .endif
        ADDX    ray_point, stream_one, ray_point
        .endif
        .endm

        .kernel rays
rays:
        rays_begin
        RTOR    ray_results, ray_p
        ADDX    ray_p, ray_stride, ray_q
        ADDX    ray_q, ray_stride, ray_x0
        ADDX    ray_x0, ray_stride, ray_x1
        ES      ray_at, 0
rays_next:
        ray_words
        stream_units 2, ray_y\+, ray_y\+
        SUBN    ray_y0, ray_half, ray_y0
        SUBN    ray_y1, ray_half, ray_y1
        MPYS    ray_y0, ray_width_p, ray_y0
        MPYS    ray_y1, ray_width_q, ray_y1
        ADDN    ray_y0, ray_middle_p, ray_work0
        ADDN    ray_y1, ray_middle_q, ray_work1
        STO     [ray_p, ray_at], ray_y0
        STO     [ray_q, ray_at], ray_y1
        STO     [ray_x0, ray_at], ray_work0
        STO     [ray_x1, ray_at], ray_work1
        IBXNE   ray_at, stream_one, ray_count, rays_next, ray_at
        EXIT
        .endkernel
