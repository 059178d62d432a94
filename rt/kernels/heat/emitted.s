; emitted.s - a radiating point of a surface and one direction of its radiation.
;
; Each word is in a plane of its own.

        .record EMITTED
        .field  EMITTED_POINT, 3    ; the point, in the world
        .field  EMITTED_FACE, 3    ; its outward normal, of length one
        .field  EMITTED_WEIGHT     ; an area in the world
        .field  EMITTED_RAY, 3     ; the direction, of length one
        .endrecord
