; average_vector.s - averages the samples (samples.s) of each pixel of a band.
;
; Works row by row of each plane, up to QUEUE pixels at a time.
;
; In:  the band's planes.  Out: the planes at scene_picture.

        .share  scratch
        .regs   r233, samples, sample_plane, plane_end, sample_row, sample_at
        .regs   r238, row_stride, pixel_at, pixel_to, framebuffer_left, columns
        .regs   r243, columns_left, rows_left, grid_row, grid_left, grid_at
        .regs   r248, share, middle
        .endshare

        .kernel frame
average:
        load_word scene_samples, samples
        IBXLE   samples, r0, one_index, average_none
        BIM     average_begin
average_none:
        BIM     0, link
        .endkernel

        .kernel average
average_begin:
        RTOR    link, link_levels
        load_word scene_gamma, exponent
        ADDN    samples, r0, s3
        MPYS    s3, s3, share
        DIVS    one, share, share
        load_word scene_width, s2
        FLR     s2, row_stride
        SHIFTI  row_stride, 6, row_stride
        DIVS    s2, s3, s2
        FLR     s2, columns
        SHIFTI  samples, -1, s2
        ES      s3, 64
        ADDX    row_stride, s3, s3
        MPYX    s2, s3, middle
        load_word scene_frame, sample_plane
        load_word scene_picture, pixel_at
        ES      framebuffer_left, FRAME_CHANNELS
        ES      h, 0
average_plane:
        load_word scene_pixels, s2
        SHIFTI  s2, 6, s2
        ADDX    sample_plane, s2, plane_end
        RTOR    sample_plane, sample_row
average_row:
        RTOR    sample_row, sample_at
        RTOR    columns, columns_left
average_pixels:
        EX      s2, QUEUE
        IBXLE   s2, r0, columns_left, average_lengths
        RTOR    columns_left, s2
average_lengths:
        IBXEQ   s2, r0, h, average_some
        RTOR    s2, h
        EX      target, set_hits
        BSAVE   link_inner, [target]
        INTVLV  r0, samples, [at]
average_some:
        ADDLEN  pixel_at, h, pixel_to
        ES      s2, FRAME_CHANNELS - 3
        IBXLE   framebuffer_left, r0, s2, average_middle
        VTOV    r0, [red]
        RTOR    sample_at, grid_row
        RTOR    samples, rows_left
average_grid:
        RTOR    grid_row, grid_at
        RTOR    samples, grid_left
average_sample:
        VXTOV   [at], [grid_at], [v0]
        CFPEQ   exponent, one, average_linear
        power_of_positive
average_linear:
        ADDNV   [red], [v0], [red]
        IX      grid_at, 64
        IBXNE   grid_left, minus_one_index, r0, average_sample, grid_left
        ADDX    grid_row, row_stride, grid_row
        IBXNE   rows_left, minus_one_index, r0, average_grid, rows_left
        MPYSV   [red], share, [pixel_to]
        BIM     average_next
average_middle:
        ADDX    sample_at, middle, s2
        VXTOV   [at], [s2], [pixel_to]
average_next:
        SHIFTI  h, 6, s2
        ADDX    pixel_at, s2, pixel_at
        MPYX    s2, samples, s2
        ADDX    sample_at, s2, sample_at
        SUBX    columns_left, h, columns_left
        IBXNE   columns_left, r0, r0, average_pixels
        MPYX    row_stride, samples, s2
        ADDX    sample_row, s2, sample_row
        IBXNE   sample_row, r0, plane_end, average_row
        RTOR    plane_end, sample_plane
        IBXNE   framebuffer_left, minus_one_index, r0, average_plane, framebuffer_left
        RTOR    link_levels, link
        BIM     0, link
        .endkernel
