; faces.s - selects the points of a primitive at which the primitive is visible.
;
; This is the common part of the two forms. Each point is the origin of a line
; along its normal. A point is kept if its line has a crossing with the
; primitive nearer than FACE_NEAR to the origin, because crossings within
; k_delta of a point are at the point. If faces of several objects coincide and
; have one direction, the first primitive in the scene owns them: a point is
; dropped if an equally near crossing of the same direction is on an earlier
; primitive.
;
; If the line enters a body at the point, the normal points inward, because
; triangles of a mesh have no outward side. The vectors of the point are
; then reversed.
;
; In:  the words below.
; Out: faces_results: the planes of the kept points, in order, each as long as
;      those of all points; after the planes the number of kept points, an
;      integer.
; Source: derived here, from the project's notes on radiant heat.

        .include "points/planes.s"

        .record FACE                    ; a crossing's words: planes
        .field  FACE_DISTANCE           ; from the origin of its line
        .field  FACE_PRIMITIVE          ; number of the primitive, an integer
        .field  FACE_POINT              ; number of the line, an integer
        .field  FACE_SIGN               ; 1: the line leaves a body, 2: no body
                                        ; is known, 3: it enters one
        .endrecord

        .data
faces_arguments:
faces_points:   .word 0                 ; points, 1 .. 65535, an integer
faces_planes:   .word 0                 ; planes of a point, an integer
faces_from:     .word 0                 ; address of the planes
faces_results:  .word 0                 ; address of as many planes, and a word
faces_crossings: .word 0                ; number of crossings, an integer
faces_list:     .word 0                 ; address of their planes
faces_primitive: .word 0                ; number of the primitive
faces_vectors:  .word 0                 ; bit k: plane k is of a reversed vector
faces_kept:     .word 0                 ; address of a plane of zeros; later the
                                        ; direction of each point on a face
                .word 1e-7              ; FACE_NEAR
                .word 1, -1
                .equ    FACES_ARGUMENTS, 12
        .code

        .regs   r10, face_points, face_planes, face_from, face_results, face_crossings, face_list
        .equ    FACE_INWARD, 3          ; a direction
        .regs   r16, face_primitive, face_vectors, face_kept, face_near, face_one, face_minus_one
        .regs   r22, face_stride        ; bits between planes of points
        .regs   r23, face_step          ; bits between planes of crossings
        .regs   r24, face_count, face_at, face_to, face_work, face_left, face_row

        .entry  faces
        .kernel faces
faces:
        load_words faces_arguments, FACES_ARGUMENTS, face_points, face_work
        SHIFTI  face_points, 6, face_stride
        SHIFTI  face_crossings, 6, face_step
        by_hand heat/faces
        .endkernel
