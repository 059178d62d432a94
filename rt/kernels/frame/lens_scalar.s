; lens_scalar.s - computes a ray through a lens (lens.s), like lens_vector.s.
;
; In:  g_column, g_row; g_dx g_dy g_dz, not normalised; g_ox g_oy g_oz of an
;      orthographic camera, or g_lx g_ly g_lz, the location of another camera.
; Out: g_dx g_dy g_dz, not normalised; g_ox g_oy g_oz.

        .share  local
        .regs   r58, g_across, g_table, g_place, g_plane
        .endshare

        .macro  within_pixel position, into
        DIVS    \position, g_across, \into
        FLR     \into, \into
        ADDN    \into, r0, \into
        MPYS    \into, g_across, \into
        SUBN    \position, \into, \into
        .endm

        .macro  through_lens location, o, d
        LOD     [g_table, g_place], g_t
        .if     ORTHOGRAPHIC
        ADDN    \o, g_t, \o
        .else
        ADDN    g_t, \location, \o
        .endif
        MPYS    g_t, g_focus, g_t
        SUBN    \d, g_t, \d
        .endm

        .macro  lens_ray
        EX      g_table, scene_samples
        LOD     [g_table], g_plane
        ADDN    g_plane, r0, g_across
        within_pixel g_column, g_place
        within_pixel g_row, g_t
        MPYS    g_t, g_across, g_t
        ADDN    g_t, g_place, g_place
        FLR     g_place, g_place
        MPYX    g_plane, g_plane, g_plane
        SHIFTI  g_plane, 6, g_plane
        EX      g_table, scene_lens
        LOD     [g_table], g_table
        through_lens g_lx, g_ox, g_dx
        ADDX    g_table, g_plane, g_table
        through_lens g_ly, g_oy, g_dy
        ADDX    g_table, g_plane, g_table
        through_lens g_lz, g_oz, g_dz
        .endm
