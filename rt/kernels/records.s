; records.s - what the host lays out in the machine's memory.
;
; rt/layout.c finds these offsets, in words, by their names; so they are
; written once, here.  Numbers are normalised 64-bit words in world units;
; colours are linear.

; A primitive.
        .equ    P_KERNEL, 0        ; address of the routine that meets a ray
        .equ    P_INNER, 1         ; .. of the one in its own space, under
                                ;    P_KERNEL = transformed
        .equ    P_NORMAL, 2        ; address of the routine for the normal
        .equ    P_ID, 3            ; its number, from 1, as an integer
        .equ    P_ON_PATCH, 4      ; 1: a hit has two parameters, too
        .equ    P_CHECKER, 5       ; 1: the pigment is a checker
        .equ    P_TRANSFORMED, 6   ; 1: the shape stands in a space of its own
        .equ    P_TABLE, 7         ; address of the words that P_SHAPE has no
                                ; room for
        .equ    P_SHAPE, 8         ; 16 words, by kind:
                                ;   sphere    centre 3, r^2, 1/r
                                ;   box       least corner 3, greatest 3,
                                ;             centre 3, half edge 3
                                ;   cylinder  centre 3, unit axes u 3, v 3,
                                ;             w 3 (along), r^2, half length,
                                ;             1/(2 r), 1/r
                                ;   plane     unit normal 3, distance
                                ;   cone      centre 3, unit axes 9, mean
                                ;             radius, slope, half length,
                                ;             1/sqrt(1 + slope^2)
                                ;   quadric   centre 3, matrix xx yy zz xy
                                ;             xz yz, half of the linear terms
                                ;             3, constant, about the centre
                                ;   torus     rho, b0, a0, a0/2, square of its
                                ;             bound, R^2 + r^2, r^2, 2 a0,
                                ;             resolution of its roots
                                ;   quartic   farthest distance, resolution;
                                ;             table: its 35 coefficients
                                ;   steiner   centre 3, square of its bound,
                                ;             what is parallel, what nothing;
                                ;             resolution of distances;
                                ;             table: K0 .. K5, their weights,
                                ;             another plane (steiner_vector.s)
        .equ    SHAPE_SIZE, 16
        .equ    P_LOCAL, 24        ; 12: rows of the matrix from world to own
                                ; space, each three factors and a shift
        .equ    P_COLOR, 36        ; 6: pigment, and the checker's second
        .equ    P_PATTERN, 42      ; 12: from world to the pigment's space
        .equ    P_FINISH, 54       ; 8: ambient 3 (times the ambient light),
                                ; diffuse, phong, phong_size, specular,
                                ; 1/roughness
        .equ    P_PATCH_POINT, 62  ; 2: the parameters of the last hit, written
                                ; by the scalar form only
        .equ    P_SIZE, 64

; A light: position 3, colour 3, and 1 if it makes highlights, else 0 (POV-Ray's
; shadowless lights make none).
        .equ    LIGHT_SIZE, 7

; The frame: planes of FRAME_CHANNELS numbers, pixel by pixel, top row first.
        .equ    FRAME_CHANNELS, 8  ; red green blue depth normal 3 id

        .data
; The scene, filled by the host.
scene_camera:     .space 12     ; location, direction, right, up
scene_width:      .word 0       ; of the frame, pixels, as numbers
scene_height:     .word 0
scene_background: .space 3
scene_pixels:     .word 0       ; width x height, as an integer
scene_primitives: .word 0       ; address of the first, and how many
scene_primitive_count: .word 0
scene_lights:     .word 0       ; address of the first, and how many
scene_light_count: .word 0
scene_frame:      .word 0       ; address of the first plane

; What camera.s makes of the camera.
        .equ    VIEW_SIZE, 12
view:             .space VIEW_SIZE ; location, then per axis: the ray through
                                ; the first pixel, its change per column and
                                ; per row: base 3, per column 3, per row 3

; Numbers that both forms of the program use.
constants:
k_one:          .word 1.0
k_half:         .word 0.5
k_two:          .word 2.0
k_big:          .word 1e30      ; beyond every scene: "no intersection"
k_minus_big:    .word -1e30
k_tiny:         .word 1e-12     ; a ray that approaches less is parallel
k_tmin:         .word 1e-6      ; a hit nearer than this is the ray's start
k_checker:      .word 1e-10     ; added before floor, against ragged faces
        .equ    CONSTANTS, 8       ; so many in registers
k_lower:        .word 1.000000000001e-6 ; tmin to be scaled: what is beyond it
                                ; there is beyond tmin here
        .code
