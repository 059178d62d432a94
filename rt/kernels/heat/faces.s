; faces.s - of points of a primitive those that stay: where the primitive is seen; what
; the two forms have in common.
;
; A line along the normal has gone through each point, its origin.  A point stays if among
; the crossings of its line there is one with the primitive nearer than FACE_NEAR to the
; origin: what is within k_delta of a point is where it is.  Where objects have faces in one
; place that look one way the first primitive of the scene has it: a point goes if there is a
; crossing as near with one before it, of the same sense.
;
; Where its line comes into a body the normal points inward, for a mesh does not know which side
; of a triangle is outside: the vectors of the point are turned round.
;
; In:  what stands below.
; Out: faces_made: the planes of the points that stay, in their order, each as long as
;      those of all points; behind the planes how many they are, an integer.
; Source: derived here, from the project's notes on radiant heat.

        .record FACE                    ; a crossing's words: planes
        .field  FACE_DISTANCE           ; from the origin of its line
        .field  FACE_PRIMITIVE          ; its number, an integer
        .field  FACE_POINT              ; number of the line, an integer
        .field  FACE_SENSE              ; 1 .. 3: the line leaves a body there, none is
                                        ; known, it comes into one
        .endrecord

        .data
faces_given:
faces_points:   .word 0                 ; how many, 1 .. 65535, an integer
faces_planes:   .word 0                 ; planes of a point, an integer
faces_from:     .word 0                 ; address of the planes
faces_made:     .word 0                 ; .. of as many, and a word
faces_crossings: .word 0                ; how many, an integer
faces_list:     .word 0                 ; address of their planes
faces_primitive: .word 0                ; the primitive's number
faces_vectors:  .word 0                 ; bit k: plane k is of a vector that is turned, too
faces_kept:     .word 0                 ; address of a plane of zeros; then of each point
                                        ; that is on a face the sense of that
                .word 1e-7              ; FACE_NEAR
                .word 1, -1
                .equ    FACES_GIVEN, 12
        .code

        .regs   r10, face_points, face_planes, face_from, face_made, face_crossings, face_list
        .equ    FACE_INWARD, 3          ; a sense
        .regs   r16, face_primitive, face_vectors, face_kept, face_near, face_one, face_minus_one
        .regs   r22, face_stride        ; from a plane of points to the next, in bits
        .regs   r23, face_step          ; .. of crossings
        .regs   r24, face_count, face_at, face_to, face_work, face_left, face_row

        .macro  faces_begin
        EX      face_work, faces_given
        ELEN    face_work, FACES_GIVEN
        SWAP    [face_work], face_points, [r0]
        SHIFTI  face_points, 6, face_stride
        SHIFTI  face_crossings, 6, face_step
        .endm
