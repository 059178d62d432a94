; average_scalar.s - averages the samples (samples.s) of each pixel of a band.
;
; Works plane by plane, pixel by pixel. The operations and their order are those
; of average_vector.s.
;
; In:  the band's planes.  Out: the planes at scene_picture.
; Called by link; may overwrite the registers of subroutines.

        .share  local
        .regs   r32, samples, sample_plane, plane_end, sample_row, sample_at
        .regs   r37, row_stride, pixel_at, framebuffer_left, columns
        .regs   r41, columns_left, rows_left, grid_row, grid_left, grid_at
        .regs   r46, share, middle, average_at, average_t, sum
        .regs   r51, plane_bits, sample_step, grid_step, colours_end
        .endshare

        .kernel frame
average:
        load_at scene_samples, 1, samples
        IBXLE   samples, r0, m_index_one, average_none
        BIM     average_begin
average_none:
        BIM     0, link
        .endkernel

        .kernel average
average_begin:
        load_at scene_picture, 1, pixel_at
        load_at scene_gamma, 1, exponent
        ADDN    samples, r0, average_t
        MPYS    average_t, average_t, share
        DIVS    m_one, share, share
        load_at scene_width, 1, columns
        FLR     columns, row_stride
        SHIFTI  row_stride, 6, row_stride
        DIVS    columns, average_t, columns
        FLR     columns, columns
        SHIFTI  samples, -1, middle
        ES      average_t, 64
        ADDX    row_stride, average_t, average_t
        MPYX    middle, average_t, middle
        load_at scene_frame, 1, sample_plane
        load_at scene_pixels, 1, plane_bits
        SHIFTI  plane_bits, 6, plane_bits
        SHIFTI  samples, 6, sample_step
        MPYX    row_stride, samples, grid_step
        ES      framebuffer_left, FRAME_CHANNELS
        ES      colours_end, FRAME_CHANNELS - 3
average_plane:
        ADDX    sample_plane, plane_bits, plane_end
        RTOR    sample_plane, sample_row
average_row:
        RTOR    sample_row, sample_at
        RTOR    columns, columns_left
average_pixel:
        IBXLE   framebuffer_left, r0, colours_end, average_middle
        RTOR    m_zero, sum
        RTOR    sample_at, grid_row
        RTOR    samples, rows_left
average_grid:
        RTOR    grid_row, grid_at
        RTOR    samples, grid_left
average_sample:
        LOD     [grid_at], p_x
        CFPEQ   exponent, m_one, average_linear
        power_of_positive
average_linear:
        ADDN    sum, p_x, sum
        IX      grid_at, 64
        IBXNE   grid_left, m_index_minus_one, r0, average_sample, grid_left
        ADDX    grid_row, row_stride, grid_row
        IBXNE   rows_left, m_index_minus_one, r0, average_grid, rows_left
        MPYS    sum, share, sum
        BIM     average_store
average_middle:
        ADDX    sample_at, middle, average_at
        LOD     [average_at], sum
average_store:
        STO     [pixel_at], sum
        IX      pixel_at, 64
        ADDX    sample_at, sample_step, sample_at
        IBXNE   columns_left, m_index_minus_one, r0, average_pixel, columns_left
        ADDX    sample_row, grid_step, sample_row
        IBXNE   sample_row, r0, plane_end, average_row
        RTOR    plane_end, sample_plane
        IBXNE   framebuffer_left, m_index_minus_one, r0, average_plane, framebuffer_left
        BIM     0, link
        .endkernel
