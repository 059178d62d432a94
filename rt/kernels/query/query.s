; query.s - arguments and results of the programs that follow lines.
;
; The programs compute all visible crossings along each line, in order. A line
; is a ray with an origin and a direction of any length but 0, which the
; programs normalise, so distances are lengths in the world. It begins
; lines_behind before its origin, where distances are negative.
;
; A crossing is visible if the tree of its region changes there
; (solids/visible_scalar.s). Regions are independent of each other. Crossings
; are ordered by distance. At equal distances the lower primitive number is
; first. The words of the k-th crossing of line r are at
;
;   lines_found + 64 (lines_count (SEEN_SIZE k + w) + r)    w: a field of SEEN
;
; These are planes, a column of planes for each k, so that a field of the k-th
; crossings of a queue's lines is a vector. Words after the last crossing of a
; line are undefined.
; Source: derived here, from the project's notes on ray tracing, 4.1.

; 1: the normals at crossings are requested.
        .ifndef NORMALS
        .equ    NORMALS, 0
        .endif

        .record SEEN
        .field  SEEN_DISTANCE           ; from the line's origin
        .field  SEEN_PRIMITIVE          ; P_ID of the primitive
        .field  SEEN_SENSE              ; an integer, 1: the line enters the
                                        ; body of the region, -1: it leaves it,
                                        ; 0: the region has none (R_BODY)
        .field  SEEN_POINT, 2           ; P_PATCH_POINT of a patch, mesh; or 0
        .if     NORMALS
        .field  SEEN_NORMAL, 3          ; in the world, of length one, against
                                        ; the line
        .endif
        .if     BODIES
        .field  SEEN_OBJECT_DEPTH             ; number of bodies of the object that
                                        ; contain the line after the crossing:
                                        ; sum of senses, an integer
        .field  SEEN_SCENE_DEPTH             ; the same for all objects
        .endif
        .endrecord

        .if     BODIES
        .equ    SEEN_FOUND, SEEN_OBJECT_DEPTH ; words stored for each crossing
        .else
        .equ    SEEN_FOUND, SEEN_SIZE
        .endif

        .data
lines_count:    .word 0                 ; number of lines, an integer
lines_rays:     .word 0                 ; address of the planes of O and D
lines_behind:   .word 0.0               ; a number
lines_counts:   .word 0                 ; address of a plane: number of
                                        ; crossings of each line, an integer;
                                        ; zeros when the program begins
lines_found:    .word 0                 ; address of the planes of crossings
lines_list:     .word 0                 ; address of room for one line's
                                        ; crossings; scalar form only
lines_inside:   .word 0                 ; address of INSIDE_SIZE words for each
                                        ; object: zeros before and after a line
        .code
