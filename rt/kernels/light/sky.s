; sky.s - the sky, written by the host: of a gradient or another pattern.

scene_sky:      .space 4        ; how a direction's value grows with it, and begins
                .word 0         ; address of its map's first stop; 0: there is no sky
                .word 0         ; how many are behind that, an integer
        .if     PATTERNS
sky_pattern:    .space 12       ; of another pattern, as P_PATTERN; scene_sky has its
sky_map:        .space MAP_SIZE ; stops, too.  As P_MAP, or the first word 0
        .endif
