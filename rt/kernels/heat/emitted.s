; emitted.s - a point from which a surface radiates, and one way in which it does: a word of
; each plane.

        .record EMITTED
        .field  EMITTED_SPOT, 3    ; the point, in the world
        .field  EMITTED_FACE, 3    ; its outward normal, of length one
        .field  EMITTED_WEIGHT     ; an area in the world
        .field  EMITTED_RAY, 3     ; the direction, of length one
        .endrecord
