; sky.s - the data of the sky, written by the host: a gradient or another
; pattern.

scene_sky:      .space 4        ; coefficients of a direction's value
                .word 0         ; address of its map's first stop; 0: no sky
                .word 0         ; number of stops after the first, an integer
        .if     PATTERNS
sky_pattern:    .space 12       ; P_PATTERN of another pattern; its stops are in
sky_map:        .space MAP_SIZE ; scene_sky, too.  P_MAP, or the first word 0
        .endif
