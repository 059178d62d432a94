; query.s - arguments and results of the ray queries.
;
; A ray query computes all visible crossings along each ray, in order. A ray has
; an origin and a direction of any length but 0, which the program normalises,
; so distances are lengths in the world. It starts query_start before its
; origin, where distances are negative.
;
; A crossing is visible if the tree of its region changes there
; (solids/visible_scalar.s). Regions are independent of each other. Crossings
; are ordered by distance. At equal distances the lower primitive number is
; first. The words of the k-th crossing of ray r are at
;
;   query_hits + 64 (query_count (RAY_HIT_SIZE k + w) + r)    w: a field of
;                                                             RAY_HIT
;
; These are planes, a column of planes for each k, so that a field of the k-th
; crossings of a queue's rays is a vector. Words after the last crossing of a
; ray are undefined.
; Source: derived here, from the project's notes on ray tracing, 4.1.

; 1: the normals at crossings are requested.
        option  NORMALS

        .record RAY_HIT
        .field  RAY_HIT_DISTANCE        ; from the ray's origin
        .field  RAY_HIT_PRIMITIVE       ; P_ID of the primitive
        .field  RAY_HIT_CROSSING        ; an integer, 1: the ray enters the
                                        ; body of the region, -1: it leaves it,
                                        ; 0: the region has none (R_BODY)
        .field  RAY_HIT_POINT, 2        ; P_PATCH_POINT of a patch, mesh; or 0
        .if     NORMALS
        .field  RAY_HIT_NORMAL, 3       ; in the world, of length one, against
                                        ; the ray
        .endif
        .if     DEPTHS
        .field  RAY_HIT_OBJECT_DEPTH    ; number of bodies of the object that
                                        ; contain the ray after the crossing:
                                        ; sum of RAY_HIT_CROSSING, an integer
        .field  RAY_HIT_SCENE_DEPTH     ; the same for all objects
        .endif
        .endrecord

        .if     DEPTHS
        .equ    RAY_HIT_WORDS, RAY_HIT_OBJECT_DEPTH ; words stored for each crossing
        .else
        .equ    RAY_HIT_WORDS, RAY_HIT_SIZE
        .endif

        .data
query_count:    .word 0                 ; number of rays, an integer
query_rays:     .word 0                 ; address of the planes of O and D
query_start:    .word 0.0               ; a number
query_counts:   .word 0                 ; address of a plane: number of
                                        ; crossings of each ray, an integer;
                                        ; zeros when the program begins
query_hits:     .word 0                 ; address of the planes of crossings
query_list:     .word 0                 ; address of room for one ray's
                                        ; crossings; scalar form only
query_depths:   .word 0                 ; address of DEPTH_SIZE words for each
                                        ; object: zeros before and after a ray
        .code
