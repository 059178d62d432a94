; generate.s - generates the ray of one pixel, or the rays of a queue.
;
; A ray is base + column per_column + row per_row (camera.s), normalised.
; Perspective rays start at one point, the location. Orthographic rays have one
; direction and start at the computed points. Rays through a lens have many
; origins (lens.s).
;
; The scalar form:
;
;       CALL GENERATE_RAY (PIXEL, VIEW, RAY)
;
; PIXEL = column, row (2 words, normalised). VIEW as computed by camera.s.
; RAY = O, D (6 words).
;
; The vector form generates n rays. Pixel k of the frame is in row
; floor(k / width) and column k - width row. The division truncates towards
; zero, so its floor is the row for every k. Queues of tiles: order_vector.s.
;
; In:  position (the first k, relative to the band's first pixel), n; view.
; Out: adx ady adz; if ORIGINS_DIFFER also aox aoy aoz.
; Source: camera.s for the formula. Vectors of any length are derived here.

        .kernel generate
        begin_rays
        .if     ORTHOGRAPHIC
        aim     g_ox, g_oy, g_oz
        copy_three g_lx, g_ly, g_lz, g_dx, g_dy, g_dz, set
        .else
        aim     g_dx, g_dy, g_dz
        .endif
        .if     LENS
        lens_rays
        .endif
        .if     LENS || ! ORTHOGRAPHIC
        unit_vector g_dx, g_dy, g_dz, g_t, g_u
        .endif
        end_rays
        .endkernel
