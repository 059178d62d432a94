; query.s - what a caller says of lines, and what is found of them: all that is seen
; along each, in order.
;
; A line is a ray from an origin in a direction of any length but 0, which the
; programs bring to length one; so distances are lengths in the world.  It begins
; lines_behind before its origin, where distances are below 0.
;
; A crossing is seen where its region's tree changes (solids/visible_scalar.s): so
; each region tells what is seen of it, whatever the others do.  In the order of
; distances, of equals in that of primitives' numbers, the words of the k-th crossing
; of line r stand at
;
;   lines_found + 64 (lines_count (SEEN_SIZE k + w) + r)       w: a field of SEEN
;
; which are planes, a column of them for each k, so that a field of the k-th crossings
; of a queue's lines is a vector.  What is in planes behind a line's last crossing means
; nothing.
; Source: derived here, from the project's notes on ray tracing, 4.1.

; 1: the normals at crossings are asked.
        .ifndef NORMALS
        .equ    NORMALS, 0
        .endif

        .record SEEN
        .field  SEEN_DISTANCE           ; from the line's origin
        .field  SEEN_PRIMITIVE          ; P_ID of what is seen there
        .field  SEEN_SENSE              ; an integer, 1: the line comes into the
                                        ; body of the region, -1: it leaves it,
                                        ; 0: the region has none (R_BODY)
        .field  SEEN_POINT, 2           ; as P_PATCH_POINT, of patches and meshes;
                                        ; else 0
        .if     NORMALS
        .field  SEEN_NORMAL, 3          ; in the world, of length one, against the
        .endif                          ; line
        .if     BODIES
        .field  SEEN_OBJECT_DEPTH             ; in how many bodies of its object the line
                                        ; is behind it: senses added up, an integer
        .field  SEEN_SCENE_DEPTH             ; .. of all objects
        .endif
        .endrecord

        .if     BODIES
        .equ    SEEN_FOUND, SEEN_OBJECT_DEPTH ; words that belong to a crossing from the first
        .else
        .equ    SEEN_FOUND, SEEN_SIZE
        .endif

        .data
lines_count:    .word 0                 ; how many lines, an integer
lines_rays:     .word 0                 ; address of six planes: origins, directions
lines_behind:   .word 0.0               ; a number
lines_counts:   .word 0                 ; address of a plane: how many each has, an
                                        ; integer; zeros when the program begins
lines_found:    .word 0                 ; address of the planes of crossings
lines_list:     .word 0                 ; address of room for those of one line, one
                                        ; behind the other; for the scalar form
lines_inside:   .word 0                 ; .. for INSIDE_SIZE words of each object: zeros
                                        ; before a line and behind it
        .code
