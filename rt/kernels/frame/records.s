; records.s - what the host lays out in the machine's memory.
;
; rt/layout/layout.c finds these offsets, in words, by their names; so they are
; written once, here.  Numbers are normalised 64-bit words in world units;
; colours are linear.

; 1: bodies are counted along lines (lines/query.s).
        .ifndef BODIES
        .equ    BODIES, 0
        .endif

; 1: there are finishes that depend on the angle (light/gloss.s).
        .ifndef GLOSS
        .equ    GLOSS, 0
        .endif

; 1: light passes through something (light/interior.s).
        .ifndef INTERIORS
        .equ    INTERIORS, 0
        .endif

; 1: there are regions that some rays do not see (R_HIDDEN_FROM).
        .ifndef HIDDEN
        .equ    HIDDEN, 0
        .endif

; 1: surfaces of different regions may coincide: hits have keys (docs/solids.md).
        .ifndef KEYS
        .equ    KEYS, 0
        .endif

; 1: of a mesh more is asked than what a ray meets first: it stands in a tree, or light
; passes through it (shapes/mesh_crossings_vector.s).
        .ifndef MESH_CROSSINGS
        .equ    MESH_CROSSINGS, 0
        .endif

; 1: there are patterns besides checkers and gradients (light/pattern.s).
        .ifndef PATTERNS
        .equ    PATTERNS, 0
        .endif

; 1: .. and pigments that are images (light/image.s).
        .ifndef IMAGES
        .equ    IMAGES, 0
        .endif

; 1: .. and normals that these change (light/bump.s).
        .ifndef BUMPS
        .equ    BUMPS, 0
        .endif

; 1: there are lathes (shapes/lathe_vector.s).
        .ifndef LATHES
        .equ    LATHES, 0
        .endif

; 1: there are prisms of quadratic splines (shapes/quadratic_prism_vector.s).
        .ifndef QUADRATIC_PRISMS
        .equ    QUADRATIC_PRISMS, 0
        .endif

; A primitive.
        .equ    SHAPE_SIZE, 16
        .equ    PATCH_CROSSINGS, 4 ; the most of a ray with a patch
        .record P
        .field  P_KERNEL           ; address of the routine that meets a ray
        .field  P_INNER            ; .. of the one in its own space, under
                                ;    P_KERNEL = transformed
        .field  P_NORMAL           ; address of the routine for the normal
        .field  P_ID               ; its number, from 1, as an integer
        .field  P_ON_PATCH         ; 1: a hit has two parameters, too: on a
                                ;    patch s and t, on a cylinder of 1984
                                ;    the surfaces of entry and exit
                                ; 2: of a mesh all of whose crossings are
                                ;    asked: the triangle, and 1 if the ray
                                ;    leaves it there, for it has no outside
                                ;    of its own; 3: its normals point
                                ;    outwards; 4: it is not seen
        .field  P_PIGMENT          ; 0: a colour, 1: a checker, 2: a gradient,
                                ; 3: another pattern, 4: an image
        .field  P_TRANSFORMED      ; 1: the shape stands in a space of its own
        .field  P_TABLE            ; address of the words that P_SHAPE has no
                                ; room for
        .field  P_SHAPE, SHAPE_SIZE ; by kind:
                                ;   sphere    centre 3, r^2, 1/r
                                ;   box       least corner 3, greatest 3,
                                ;             centre 3, half edge 3
                                ;   cylinder  centre 3, unit axes u 3, v 3,
                                ;             w 3 (along), r^2, half length,
                                ;             1/(2 r), 1/r
                                ;             of 1984: base 3, unit axis 3,
                                ;             r, planes of base and cap, each
                                ;             p 3 and q, outside p . X + q > 0,
                                ;             1/r
                                ;   plane     unit normal 3, distance
                                ;   disc      as a plane, centre 3, squares
                                ;             of its radius and its hole's
                                ;   cone      centre 3, unit axes 9, mean
                                ;             radius, slope, half length,
                                ;             1/sqrt(1 + slope^2)
                                ;   quadric   centre 3, matrix xx yy zz xy
                                ;             xz yz, half of the linear terms
                                ;             3, constant, about the centre
                                ;   torus     rho, b0, a0, a0/2, square of its
                                ;             bound, R^2 + r^2, r^2, 2 a0,
                                ;             resolution of its roots, half
                                ;             distance of the planes about it
                                ;   quartic   farthest distance, resolution;
                                ;             table: its 35 coefficients
                                ;   steiner   centre 3, square of its bound,
                                ;             what is parallel, what nothing;
                                ;             resolution of distances;
                                ;             table: K0 .. K5, their weights,
                                ;             another plane (steiner_patch_vector.s)
                                ;   prism     low, high, how many rows; table:
                                ;             rows, as below
                                ;   blob      centre 3, square of its bound,
                                ;             threshold, how many rows,
                                ;             resolution of distances;
                                ;             table: rows, as below
                                ;   lathe     height of its middle, square of its radius,
                                ;             half of its height, how many rows are seen,
                                ;             how many there are, a distance that
                                ;             points on it are within: its square, and
                                ;             a little more; table: rows, as below
                                ;   quadratic_prism  as a prism; table: rows, as
                                ;             below
                                ;   mesh      words of a triangle's row, room for so
                                ;             many crossings; of one with a
                                ;             body, too: where its table
                                ;             stands in this, in words; room
                                ;             for so many crossings; table:
                                ;             nodes and triangles, as below
        .field  P_LOCAL, 12        ; rows of the matrix from world to own
                                ; space, each three factors and a shift
        .field  P_COLOR, 6         ; pigment, and the checker's second
        .field  P_PATTERN, 12      ; from world to the pigment's space; of a gradient
                                ; as scene_sky
        .if     PATTERNS
        .field  P_MAP, 8           ; of another pattern: a MAP (light/pattern.s)
        .endif
        .if     BUMPS
        .field  P_BUMP             ; address of what changes its normals, or 0
        .endif
        .field  P_FINISH, 8        ; ambient 3 (times the ambient light),
                                ; diffuse, phong, phong_size, specular,
                                ; 1/roughness
        .if     GLOSS
        .field  P_GLOSS, 2         ; brilliance; how metallic highlights are
        .field  P_REFLECTION_RANGE, 3 ; of P_REFLECTION, as the angle has it:
                                ; most less least,
        .field  P_REFLECTION_FALLOFF ; the power that it goes by,
        .field  P_REFLECTION_METALLIC
        .field  P_REFLECTION_KIND ; 0: it is always the same, 1: by a power,
                                ; 2: by Fresnel's formulas
        .endif
        .if     BODIES
        .field  P_OBJECT           ; of the scene, that it is a part of, an integer,
        .endif                  ; from 0 on
        .if     INTERIORS
        .field  P_INTERIOR         ; the number of its body (light/interior.s)
        .field  P_RANK             ; of its region among those with clear parts, in the
                                ; order of the scene, from 1; 0: it has none
        .endif
        .if     KEYS
        .field  P_YIELD            ; k_delta times this is added to the distance of a
                                ; hit before it is compared with other regions'
        .endif
        .field  P_PATCH_POINT, 2   ; the parameters of the last hit, written
                                ; by the scalar form only
        .field  P_STATE_KERNEL     ; under a tree, of an open shape: what gives
        .field  P_STATE_INNER      ; the segments of the closed one; else 0
        .field  P_AT_HAND          ; in a tree, written by scalar code: the next
                                ; primitive that the ray meets, the last 0
        .field  P_SEGMENTS         ; how many segments of a ray it has (0: a
                                ; surface without inside), an integer
        .field  P_EVENTS           ; how many crossings can be seen
        .field  P_FIRST_STATE      ; addresses of the first of its segments in
        .field  P_FIRST_EVENT      ; the tree, and of its crossings:
                                ; the same of a closed shape; of a patch
                                ; PATCH_CROSSINGS, missing ones big, then in
                                ; the vector form as many s, then as many t
                                ; of a mesh these three are what the last rays
                                ; have, and the triangles stand behind the room
                                ; for crossings
        .field  P_VALUE            ; address of its value in the tree
        .field  P_INVERTED         ; 1: what its outward normal points to is
                                ; solid
        .field  P_MIRROR           ; 1: it reflects
        .field  P_CLEAR            ; 1: light passes
        .field  P_INDEX, 2         ; index of refraction, its reciprocal
        .field  P_REFLECTION, 4    ; colour, of one that depends on the angle
                                ; the least; the greatest of all
        .field  P_PASSING, 8       ; the colour that passes and the greatest
                                ; of it, below 0 if it is too dim to be
                                ; followed; twice as P_COLOR
        .field  P_MATERIAL             ; address of the first primitive that looks
                                ; alike: a sphere not in a space of its own,
                                ; as this one; else its own
        .field  P_TESTED              ; written by the vector form, of the first of
                                ; a look: address of the next look that rays
                                ; of the queue have met, 1: there is none, 0:
                                ; it has not been met
        .field  P_SHARED           ; .. 1: not by this primitive alone
        .field  P_SPACE            ; the number of its own space; neighbours in
                                ; one have the same
        .field  P_PATCH_POINTS, 2 * PATCH_CROSSINGS ; s and t of each of its
                                ; crossings in a tree, written by the scalar
                                ; form only
        .endrecord
        .equ    P_STOPS, P_PATTERN + 4
        .equ    P_STOP_COUNT, P_PATTERN + 5

; The most crossings of a ray with a primitive: if it is more, the host says so
; when the program is assembled.
        .ifndef MAX_CROSSINGS
        .equ    MAX_CROSSINGS, 6
        .endif

; The most pieces of a blob (shapes/blob_vector.s): the host counts them when the
; program is assembled.  0: there are no blobs.
        .ifndef BLOB_PIECES
        .equ    BLOB_PIECES, 0
        .endif

; 1: the rays of the camera are parallel, and start at many points (camera.s).
        .ifndef ORTHOGRAPHIC
        .equ    ORTHOGRAPHIC, 0
        .endif

; 1: the camera has a lens (lens.s).
        .ifndef LENS
        .equ    LENS, 0
        .endif

; 1: pixels that differ from their neighbours get more rays (adaptive.s).
        .ifndef ADAPTIVE
        .equ    ADAPTIVE, 0
        .endif

; 1: the rays of the camera start at many points.
        .equ    EYES_APART, ORTHOGRAPHIC || LENS

; 1: there are fogs (light/fog.s).
        .ifndef FOG
        .equ    FOG, 0
        .endif

; 1: there are lights that do not shine all around, or fade (light/beam.s).
        .ifndef BEAMS
        .equ    BEAMS, 0
        .endif

; 1: .. and of these lights some have an area (light/area_vector.s).
        .ifndef AREAS
        .equ    AREAS, 0
        .endif

; A row of a prism's table: a corner of its path, and the edge back to the one
; before, as its normal wants it.
        .record PRISM
        .field  PRISM_POINT, 2     ; x, z
        .field  PRISM_BEGINS       ; 1: a loop begins here, and there is no edge
        .field  PRISM_DIRECTION, 2
        .field  PRISM_LENGTH
        .field  PRISM_NORMAL, 2    ; outward
        .endrecord

; A row of the table of a prism of a quadratic spline: a corner of its path, and
; of the parabola to there from the corner before, P, what its crossings want:
; P + (BEND w + 2 LEAD) w;  and what its normal wants: the same, but of what is
; straight from its least point to its greatest; w of a point on it, told from P.
        .record QUADRATIC
        .field  QUADRATIC_POINT, 2     ; x, z
        .field  QUADRATIC_BEGINS       ; 1: a loop begins here, and there is no parabola
        .field  QUADRATIC_BEND, 2
        .field  QUADRATIC_LEAD, 2
        .field  QUADRATIC_FOOT, 2      ; P + (BOW w + WAY) w
        .field  QUADRATIC_BOW, 2
        .field  QUADRATIC_WAY, 2
        .field  QUADRATIC_SHARE, 2     ; w = this . (point - P)
        .field  QUADRATIC_OUTWARD      ; 1, or -1: across the way to its right, or left
        .endrecord

; A row of a lathe's table: a corner of its path, its height told from the middle;
; of the segment back to the one before, what crossings want: its heights, if it
; rises to here (1) or falls, its line  nr r + ny y = k,  nr >= 0; and what its
; normal wants.
        .record LATHE
        .field  LATHE_SQUARE       ; r^2
        .field  LATHE_HEIGHT
        .field  LATHE_BEGINS       ; 1: the path begins here, and there is no segment
        .field  LATHE_LOW
        .field  LATHE_HIGH
        .field  LATHE_RISES
        .field  LATHE_LINE, 4      ; ny, k, nr^2, nr
        .field  LATHE_RADIUS       ; r
        .field  LATHE_DIRECTION, 2 ; in r and y, of length one
        .field  LATHE_LENGTH
        .field  LATHE_NORMAL, 2    ; outward
        .endrecord

; A row of a blob's table: a component.  The space of its own is that in which its
; radius is one, its base the origin, and the axis of a cylinder along z.
        .record BLOB
        .field  BLOB_KIND          ; 0: a ball, 1: an ellipsoid, 2: a cylinder
        .field  BLOB_CENTER, 3     ; told from the blob's centre
        .field  BLOB_SQUARE        ; of a ball's radius, and
        .field  BLOB_INVERSE       ; its reciprocal
        .field  BLOB_STRENGTH
        .field  BLOB_LENGTH        ; of a cylinder, in its own space; else 0
        .field  BLOB_MATRIX, 12    ; from there to its own space: rows of three
                                ; factors and a shift
        .endrecord

; The table of a mesh: a row of zeros but for its end, the nodes of a hierarchy of boxes,
; in preorder, the triangles, and what eyes see of it.  A row is told by how many words stand before it.
; By the signs of a ray's direction (1: x below 0, 2: y, 4: z) a node tells where
; the rays that come near it go on, and where the others do: among the nodes, or
; 0, the end.  Near a leaf they go on where the others do, and the link is
; greater by MESH_MET.  Of the first row MESH_FIRST and MESH_COUNT tell of the eyes
; that the mesh is seen from (rt/shapes/screen_bounds.h): where their rows begin, and how
; many they are.
        .record MESH
        .field  MESH_BOX, 6        ; centre 3, half sides 3
        .field  MESH_LINKS, 16     ; near, not near; for each of eight signs
        .field  MESH_FIRST         ; of a leaf: its first triangle, and
        .field  MESH_COUNT         ; how many stand there
        .at     25              ; odd, for the banks
        .endrecord
        .equ    MESH_MET, 1 << 40

; .. and of an eye's rows, where a node is told as above, in the same order.
        .record EYE
        .field  EYE_PLACE, 3
        .field  EYE_AXIS           ; it looks along x, y, z: 0, 1, 2
        .field  EYE_SIGN           ; 1, or -1: down that axis; a number
        .field  EYE_FAR            ; no ray that comes from farther away is told here
        .field  EYE_WINDOWS        ; its rows
        .endrecord

        .record WINDOW
        .field  WINDOW_SIDES, 4    ; least and greatest u, then v
        .field  WINDOW_NEAR        ; the least z
        .field  WINDOW_LINKS, 2    ; near, not near
        .field  WINDOW_FIRST       ; as MESH_FIRST and
        .field  WINDOW_COUNT       ; MESH_COUNT; a size that is odd, for the banks
        .endrecord

; 1: boxes are asked of all rays, of those through an eye, too.
        .ifndef MESH_BOXES
        .equ    MESH_BOXES, 0
        .endif

        .record TRIANGLE
        .field  TRIANGLE_CORNERS, 9
        .field  TRIANGLE_NORMAL, 3 ; of length one; of a smooth one that at the
                                ; first corner, of any length, and
        .field  TRIANGLE_CHANGE, 9 ; three rows: how it changes from there
        .endrecord

; A region: what is traced as one thing, a primitive or a Boolean tree of them.
        .record R
        .field  R_BOUND, 5         ; its bounding sphere: centre 3, radius, its
                                ; square; big: no bound
        .field  R_WAY              ; REGION_SIMPLE: one primitive, of which the
                                ; nearest crossing ahead is all that is wanted;
                                ; REGION_BOXED: with a box; or both, or 0
        .field  R_SHADOW           ; 0: casts no shadow, 1: a full one, 2: parts
                                ; of it are clear
        .field  R_NODES            ; address of its first node, of what stands
        .field  R_NODES_END        ; behind the last
        .field  R_FIRST            ; address of its first primitive
        .field  R_RESULT           ; address of the tree's value
        .field  R_CLEAR            ; address of its word in scene_clear, where
                                ; parts of it are clear
        .field  R_BOX, 6           ; its box: centre 3, half sides 3
        .field  R_BODY             ; an integer, 1: what is inside of it is where
                                ; its value is 1, -1: where it is 0; 0: it is
                                ; open, and has no inside
        .if     HIDDEN
        .field  R_HIDDEN_FROM      ; the sum of the classes of rays that do not see
                                ; it: IMAGE_RAYS, REFLECTED_RAYS
        .at     21              ; odd, for the banks
        .else
        .at     19              ; odd, for the banks
        .endif
        .endrecord
        .equ    REGION_SIMPLE, 1
        .equ    REGION_BOXED, 2
        .equ    IMAGE_RAYS, 1      ; of the camera, as long as none is reflected
        .equ    REFLECTED_RAYS, 2  ; after a reflection, also a total one

; A node of the hierarchy over the regions, in preorder: a leaf has regions, any
; other node two nodes below it, the first of which stands behind it.
        .record H
        .field  H_BOUND, 5         ; as R_BOUND, of all regions below
        .field  H_REGIONS          ; of a leaf: address of its first region; of
                                ; another: of the second node below
        .field  H_REGION_COUNT     ; how many regions stand there; 0: no leaf
        .field  H_WAY, 3           ; from the centre of the first node below to
                                ; that of the second
        .field  H_SPHERES          ; 1: the regions below are opaque spheres, no
                                ; more than MAX_SPHERES in a leaf
        .at     13              ; odd, for the banks: fields of many are gathered
        .endrecord
        .equ    HIERARCHY_DEPTH, 96 ; nodes above one another, at most
        .equ    MAX_SPHERES, 8

; A node: the tree in preorder, without complements.  A ray that does not come
; near a node goes on behind all that is below it; the node's value is 0 then.
; The others are at hand: leaves, and branches, which have steps that make their
; value of those below.
        .record N
        .field  N_BOUND, 5         ; as R_BOUND
        .field  N_STEPS            ; address of the first of its steps, and
        .field  N_STEP_COUNT       ; how many; none: a leaf, or of one child
        .field  N_PRIMITIVE        ; address of a leaf's, or 0
        .field  N_NEEDED           ; 1: a ray that misses it sees nothing of the
                                ; tree
        .field  N_NEXT             ; address of the node to go on with
        .field  N_VALUE            ; address of its value
        .if     MESH_CROSSINGS
        .field  N_MESH             ; 1: a mesh is below it
        .endif
        .endrecord

; A step of the evaluation of a tree.  The host leaves room for the values and
; crossings of the tree that has most, VALUE_SIZE and CROSSING_SIZE words each.
        .record T
        .field  T_OPERATION        ; 0 and, 1 or, 2 and not
        .field  T_LEFT             ; addresses of values
        .field  T_RIGHT
        .field  T_RESULT
        .endrecord

; Of the region that is looked at, the leaves at hand, in the vector forms.
        .record LEAF
        .field  LEAF_PRIMITIVE
        .field  LEAF_PART, 5       ; P_SEGMENTS .. P_VALUE
        .field  LEAF_NEEDED        ; N_NEEDED
        .endrecord

; .. and the branches, each before those below it.
        .record BRANCH
        .field  BRANCH_STEPS       ; N_STEPS
        .field  BRANCH_STEP_COUNT
        .endrecord

; Of a gradient's map: a colour, and how it changes up to the next one.  The
; first is at -1, as long as none is met.
        .record STOP
        .field  STOP_AT
        .field  STOP_SLOPE         ; 1 / how far the next one is; 0: it is there
        .field  STOP_COLOR, 3
        .field  STOP_CHANGE, 3
        .endrecord

; A light.
        .record LIGHT
        .field  LIGHT_POSITION, 3
        .field  LIGHT_COLOR, 3
        .field  LIGHT_GLEAMS       ; 1: it makes highlights (POV-Ray's
                                ; shadowless lights make none)
        .if     BEAMS
        .field  LIGHT_BEAM         ; address of its beam, or 0: it shines all
                                ; around, with the same strength everywhere
        .endif
        .endrecord

; The frame: planes of FRAME_CHANNELS numbers, pixel by pixel, top row first.
        .equ    FRAME_CHANNELS, 8  ; red green blue depth normal 3 id

        .data
; The scene, filled by the host.
scene_camera:     .space 12     ; location, direction, right, up
scene_width:      .word 0       ; of the frame, pixels, as numbers
scene_height:     .word 0
scene_background: .space 3
scene_band:       .word 0       ; of the band that is traced: its first row and the
                  .word 0       ; row behind its last, as numbers
scene_first_pixel: .word 0      ; .. its first pixel, of the frame's, an integer
scene_pixels:     .word 0       ; .. how many pixels it has, an integer
scene_primitives: .word 0       ; address of the first, and how many
scene_primitive_count: .word 0
scene_alike:      .word 0       ; 1: there are primitives that look alike
scene_regions:    .word 0       ; address of the first, and how many stand under
scene_region_count: .word 0     ; no node of the hierarchy: they come first
scene_region_total: .word 0     ; how many there are, with those under nodes
scene_hierarchy:  .word 0       ; address of its first node; 0: there is none
scene_clear:      .word 0       ; address of a word for each region with clear
scene_clear_count: .word 0      ; parts, in the order of the scene, and how many
scene_leaves:     .word 0       ; LEAF_SIZE words for each leaf of a tree: the list
leaves_end:       .word 0       ; of those at hand, its end, written by vector code
scene_branches:   .word 0       ; BRANCH_SIZE words for each branch: the list of
branches_end:     .word 0       ; those at hand, its end, written by vector code
scene_levels:     .word 0       ; LEVEL_SIZE words for each level of reflection
scene_level_count: .word 0      ; how many: as many rays may come of one another;
                                ; 1 if nothing reflects or is clear, an integer
scene_bailout:    .word 0       ; what weighs less is not followed, a number
scene_lights:     .word 0       ; address of the first, and how many
scene_light_count: .word 0
scene_frame:      .word 0       ; address of the band's first plane

; Rays traced, by kind: integers, for the host to read.
rays_primary:     .word 0
rays_reflected:   .word 0
rays_refracted:   .word 0
rays_shadow:      .word 0

; What camera.s makes of the camera.
        .record VIEW
        .field  VIEW_LOCATION, 3   ; of an orthographic camera the direction ..
        .field  VIEW_BASE, 3       ; direction of the ray through the first pixel,
                                ; .. its origin
        .field  VIEW_COLUMN, 3     ; its change per column
        .field  VIEW_ROW, 3        ; and per row
        .if     LENS
        .field  VIEW_FOCUS, 1      ; lens.s
        .endif
        .endrecord
view:             .space VIEW_SIZE

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
k_far:          .word 1e12      ; what lies farther along a ray is not seen
k_delta:        .word 1e-7      ; surfaces nearer than this along a ray are one
k_shadow:       .word 1e-3      ; shadows start and end so far from point and
                                ; light (POV-Ray's SHADOW_TOLERANCE)
k_lower:        .word 1.000000000001e-6 ; tmin to be scaled: what is beyond it
                                ; there is beyond tmin here
k_shadow_lower: .word 1.000000000001e-3 ; .. and k_shadow
bound_less:     .word 0.99999999999909050529   ; 1 - 2^-40, in tests of bounds
bound_lost:     .word 0.00000000000090949470   ; 2^-40, in tests of boxes
bound_more:     .word 1.00000000000090949470   ; 1 + 2^-40, where another region
                                ; may be as near
        .code
