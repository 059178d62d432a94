; lens.s - a camera's lens, in focus at one distance.
;
; The rays of a pixel's samples (samples.s) start at points L of a disk around
; the location, perpendicular to the camera's direction, one point for each
; sample. They intersect where the pinhole's ray O + t D is at the distance F
; along the direction of the camera:
;
;   O' = O + L          D' = D - (|direction| / F) L,  normalised
;
; An orthographic camera, whose D has length one, uses D - L / F. The point of a
; sample depends on its row and column within the pixel. The host lays out the
; points (rt/layout/lens.c).
; Source: the thin lens of Cook, Porter and Carpenter, "Distributed Ray Tracing"
; (1984); derived here.

        .data
scene_lens:     .word 0                 ; address of L: x of all samples of a
                                        ; pixel, row by row, then y, then z
scene_focus:    .word 1.0               ; F
        .code

; In:  g_column, g_row; g_dx g_dy g_dz, not normalised; g_ox g_oy g_oz of an
;      orthographic camera, or g_lx g_ly g_lz, the location of another camera;
;      g_focus.
; Out: g_dx g_dy g_dz, not normalised; g_ox g_oy g_oz.

; Computes the position of samples within their pixel, across or down.
        .macro  within_pixel position, into
        over_floor_normal \position, g_across, \into
        scale   \into, g_across, \into
        minus   \position, \into, \into
        .endm

        .macro  through_lens location, o, d
        gather  g_place, g_table, g_t
        .if     ORTHOGRAPHIC
        plus    \o, g_t, \o
        .else
        raise   g_t, \location, \o
        .endif
        minus_scaled \d, g_t, g_focus, \d
        .endm

        .macro  lens_rays
        load_word scene_samples, g_plane
        load_word scene_lens, g_table
        ADDN    g_plane, r0, g_across
        within_pixel g_column, g_place
        within_pixel g_row, g_t
        scaled_plus g_t, g_across, g_place, g_place
        floor   g_place, g_place
        MPYX    g_plane, g_plane, g_plane
        SHIFTI  g_plane, 6, g_plane
        through_lens g_lx, g_ox, g_dx
        ADDX    g_table, g_plane, g_table
        through_lens g_ly, g_oy, g_dy
        ADDX    g_table, g_plane, g_table
        through_lens g_lz, g_oz, g_dz
        .endm
