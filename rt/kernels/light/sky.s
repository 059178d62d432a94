; sky.s - the sky, written by the host: of a gradient.

scene_sky:      .space 4        ; how a direction's value grows with it, and begins
                .word 0         ; address of its map's first stop; 0: there is no sky
                .word 0         ; how many are behind that, an integer
