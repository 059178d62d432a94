; average.s - averages the samples (samples.s) of each pixel of a band.
;
; Works plane by plane, row by row. The scalar form averages pixel by pixel, the
; vector form up to QUEUE pixels at a time.
;
; In:  the band's planes.  Out: the planes at scene_picture.
; Called by link; may overwrite the registers of subroutines.

        .kernel frame
average:
        load_word scene_samples, samples
        IBXLE   samples, r0, m_index_one, average_none
        BIM     average_begin
average_none:
        BIM     0, link
        .endkernel

        .kernel average
average_begin:
        begin_average
        load_word scene_gamma, exponent
        ADDN    samples, r0, average_t
        MPYS    average_t, average_t, share
        DIVS    m_one, share, share
        load_word scene_width, picture_columns
        FLR     picture_columns, row_stride
        SHIFTI  row_stride, 6, row_stride
        DIVS    picture_columns, average_t, picture_columns
        FLR     picture_columns, picture_columns
        SHIFTI  samples, -1, middle
        ES      average_t, 64
        ADDX    row_stride, average_t, average_t
        MPYX    middle, average_t, middle
        load_word scene_frame, sample_plane
        load_word scene_picture, pixel_at
        ES      framebuffer_left, FRAME_CHANNELS
average_plane:
        load_word scene_pixels, average_at
        SHIFTI  average_at, 6, average_at
        ADDX    sample_plane, average_at, plane_end
        RTOR    sample_plane, sample_row
average_row:
        RTOR    sample_row, sample_at
        RTOR    picture_columns, pixels_left
average_pixels:
        begin_pixels
        IBXLE   framebuffer_left, r0, colours_end, average_middle
        set     m_zero, sum
        RTOR    sample_at, grid_row
        RTOR    samples, grid_rows
average_grid:
        RTOR    grid_row, grid_at
        RTOR    samples, grid_left
average_sample:
        fetch_samples grid_at, p_x
        CFPEQ   exponent, m_one, average_linear
        power_of_positive
average_linear:
        plus    sum, p_x, sum
        IX      grid_at, 64
        IBXNE   grid_left, m_index_minus_one, r0, average_sample, grid_left
        ADDX    grid_row, row_stride, grid_row
        IBXNE   grid_rows, m_index_minus_one, r0, average_grid, grid_rows
        scale   sum, share, pixels
        BIM     average_next
average_middle:
        ADDX    sample_at, middle, average_at
        fetch_samples average_at, pixels
average_next:
        next_pixels average_pixels
        MPYX    row_stride, samples, average_at
        ADDX    sample_row, average_at, sample_row
        IBXNE   sample_row, r0, plane_end, average_row
        RTOR    plane_end, sample_plane
        IBXNE   framebuffer_left, m_index_minus_one, r0, average_plane, framebuffer_left
        end_average
        .endkernel
