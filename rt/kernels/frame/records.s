; records.s - the records that the host lays out in the machine's memory.
;
; rt/layout/layout.c looks up these offsets, in words, by name, so this file is
; their only definition. Numbers are normalised 64-bit words in world units.
; Colours are linear.

        .include "frame/common.s"

; Constants that the host sets when the program is assembled.
        option  MAX_CROSSINGS, 6   ; the most crossings of a ray with a primitive
        option  BLOB_PIECES        ; the most pieces of a blob, or 0: no blobs
                                   ; (shapes/blob.s)

; Constants that are 1 if
        option  ADAPTIVE           ; sampling is adaptive (adaptive.s)
        option  AREAS              ; some lights have an area
                                   ; (light/area_vector.s)
        option  BEAMS              ; some lights do not shine in all directions,
                                   ; or fade (light/beam.s)
        option  BUMPS              ; patterns perturb some normals
                                   ; (light/bump.s)
        option  DEPTHS             ; the bodies that contain each ray are
                                   ; counted (query/query.s)
        option  FOG                ; there are fogs (light/fog.s)
        option  GLOSS              ; some finishes depend on the angle
                                   ; (light/gloss.s)
        option  HIDDEN             ; some regions are invisible to a class of
                                   ; rays (R_HIDDEN_FROM)
        option  IMAGES             ; some pigments are images (light/image.s)
        option  INTERIORS          ; light passes through some objects
                                   ; (light/interior.s)
        option  KEYS               ; surfaces of different regions may coincide,
                                   ; so hits have keys (docs/solids.md)
        option  LATHES             ; there are lathes (shapes/lathe.s)
        option  LENS               ; the camera has a lens (lens.s)
        option  MESH_BOXES         ; boxes of meshes are tested for all rays,
                                   ; also for those through a viewpoint
        option  MESH_CROSSINGS     ; a mesh is part of a tree, or light passes
                                   ; through it, so all its crossings are needed
                                   ; (shapes/mesh_crossings_vector.s)
        option  ORTHOGRAPHIC       ; the camera's rays are parallel and have
                                   ; many origins (camera.s)
        option  PATTERNS           ; there are patterns other than checkers and
                                   ; gradients (light/pattern.s)
        option  QUADRATIC_PRISMS   ; there are prisms of quadratic splines
                                   ; (shapes/quadratic_prism.s)
        option  SIMPLE_YIELDS      ; the primitive of a simple region has a
                                   ; P_TIE_OFFSET above 0; KEYS is 1, too
        .equ    ORIGINS_DIFFER, ORTHOGRAPHIC || LENS ; rays have many origins

; A primitive.
        .equ    SHAPE_SIZE, 16
        .equ    PATCH_CROSSINGS, 4 ; most crossings of a ray with a patch
        .record P
        .field  P_KERNEL           ; address of the intersection routine
        .field  P_INNER            ; address of the routine in object space, if
                                   ; P_KERNEL = transformed
        .field  P_NORMAL           ; address of the routine for the normal
        .field  P_ID               ; number, from 1, an integer
        .field  P_ON_PATCH         ; 1: a hit has two parameters: s and t of a
                                   ; patch, or, of a cylinder of 1984, the
                                   ; surfaces of entry and exit; 2 to 4: all
                                   ; crossings of a mesh are needed; 2: it has
                                   ; no outside, so the parameters are the
                                   ; triangle, and 1 if the ray leaves there; 3:
                                   ; its normals point outwards; 4: it is
                                   ; invisible
        .field  P_PIGMENT          ; 0: a colour, 1: a checker, 2: a gradient,
                                   ; 3: another pattern, 4: an image
        .field  P_TRANSFORMED      ; 1: the shape has an object space
        .field  P_TABLE            ; address of words that P_SHAPE cannot hold
        .field  P_SHAPE, SHAPE_SIZE ; in the order that shapes/NAME.s states
        .field  P_LOCAL, 12        ; rows of the matrix from world to object
                                   ; space, each three factors and a shift
        .field  P_COLOR, 6         ; pigment, and the checker's second colour
        .field  P_PATTERN, 12      ; from world to pigment space; of a gradient
                                   ; as scene_sky
        .if     PATTERNS
        .field  P_MAP, 8           ; of another pattern: a MAP
        .endif
        .if     BUMPS
        .field  P_BUMP             ; address of the bump of its normals, or 0
        .endif
        .field  P_FINISH, 8        ; ambient 3 (times the ambient light),
                                   ; diffuse, phong, phong_size, specular,
                                   ; 1/roughness
        .if     GLOSS
        .field  P_GLOSS, 2         ; brilliance; metallic of highlights
        .field  P_REFLECTION_RANGE, 3 ; greatest minus least, over the angles
        .field  P_REFLECTION_FALLOFF ; exponent of its change with the angle
        .field  P_REFLECTION_METALLIC
        .field  P_REFLECTION_KIND ; 0: constant, 1: a power, 2: Fresnel's law
        .endif
        .if     DEPTHS
        .field  P_OBJECT           ; object of the scene, an integer from 0
        .endif
        .if     INTERIORS
        .field  P_INTERIOR         ; number of its body (light/interior.s)
        .field  P_RANK             ; rank of its region among those with clear
                                   ; parts, in the order of the scene, from 1;
                                   ; 0: not one of them
        .endif
        .if     KEYS
        .field  P_TIE_OFFSET       ; times k_delta, added to the distance of a
                                   ; hit before regions are compared
        .endif
        .field  P_PATCH_POINT, 2   ; parameters of the last hit, written by the
                                   ; scalar form only
        .field  P_STATE_KERNEL     ; of an open shape in a tree: routines for
        .field  P_STATE_INNER      ; the segments of the closed shape; else 0
        .field  P_NEXT_HIT         ; in a tree, written by scalar code: the next
                                   ; primitive that the ray hits, or 0
        .field  P_SEGMENTS         ; most segments of a ray, an integer; 0: a
                                   ; surface without inside
        .field  P_EVENTS           ; most events of a ray
        .field  P_FIRST_STATE      ; address of its first segment in the tree
        .field  P_FIRST_EVENT      ; address of its first event: that of the
                                   ; first segment for a closed shape. A patch
                                   ; has PATCH_CROSSINGS events, missing ones
                                   ; big; in the vector form, s and t of each
                                   ; follow. For a mesh, P_SEGMENTS to
                                   ; P_FIRST_EVENT describe the last rays, and
                                   ; the triangles follow the room for crossings
        .field  P_VALUE            ; address of its value in the tree
        .field  P_INVERTED         ; 1: its normal points into the solid
        .field  P_MIRROR           ; 1: it reflects
        .field  P_CLEAR            ; 1: light passes
        .field  P_INDEX, 2         ; index of refraction, its reciprocal
        .field  P_REFLECTION, 4    ; colour (the least one, if it depends on the
                                   ; angle), greatest component
        .field  P_TRANSMITTED, 8   ; for both colours of P_COLOR: transmitted
                                   ; colour and its greatest component, negative
                                   ; if too dim to be followed
        .field  P_MATERIAL             ; address of the first primitive with the
                                       ; same material, for a sphere in world
                                       ; space; otherwise its own
        .field  P_TESTED              ; written by the vector form in the first
                                      ; primitive of a material: address of the
                                      ; next material that rays of the queue
                                      ; hit, 1: the last, 0: not hit
        .field  P_SHARED           ; 1: other primitives of it were hit
        .field  P_SPACE            ; number of its object space, equal for
                                   ; neighbours in one space
        .field  P_PATCH_POINTS, 2 * PATCH_CROSSINGS ; s and t of each crossing
                                                    ; in a tree, written by the
                                                    ; scalar form only
        .endrecord
        .if     PATTERNS
        .record MAP
        .field  MAP_FUNCTION            ; address of the routine that computes v
        .field  MAP_WAVE                ; address of the one that computes w;
                                        ; 0: v is the value
        .field  MAP_NUMBERS, 4          ; frequency, phase, exponent; for bricks
                                        ; 1 / size (3 words), mortar
        .field  MAP_STOPS               ; as P_STOPS
        .field  MAP_STOP_COUNT
        .endrecord
        .equ    P_MAP_FUNCTION, P_MAP + MAP_FUNCTION
        .equ    P_MAP_WAVE, P_MAP + MAP_WAVE
        .equ    P_MAP_NUMBERS, P_MAP + MAP_NUMBERS
        .equ    P_MAP_STOPS, P_MAP + MAP_STOPS
        .equ    P_MAP_STOP_COUNT, P_MAP + MAP_STOP_COUNT
        .endif
        .equ    P_STOPS, P_PATTERN + 4
        .equ    P_STOP_COUNT, P_PATTERN + 5

; A row of a prism's table: a corner of its path and the edge from the previous
; corner, in the form that its normal needs.
        .record PRISM
        .field  PRISM_POINT, 2     ; x, z
        .field  PRISM_BEGINS       ; 1: a loop begins here, without an edge
        .field  PRISM_DIRECTION, 2
        .field  PRISM_LENGTH
        .field  PRISM_NORMAL, 2    ; outward
        .endrecord

; A row of the table of a prism of a quadratic spline: a corner of its path and
; the parabola from the previous corner P. Crossings use its first form, normals
; the second:
;
;   P + (BEND w + 2 LEAD) w       P + (BOW w + WAY) w
;
; In the second form, a parabola that is straight is the segment from its least
; point to its greatest. The w of a point on it is linear in the point, relative
; to P.
        .record QUADRATIC
        .field  QUADRATIC_POINT, 2     ; x, z
        .field  QUADRATIC_BEGINS       ; 1: a loop begins, without a parabola
        .field  QUADRATIC_BEND, 2
        .field  QUADRATIC_LEAD, 2
        .field  QUADRATIC_FOOT, 2      ; P of P + (BOW w + WAY) w
        .field  QUADRATIC_BOW, 2
        .field  QUADRATIC_WAY, 2
        .field  QUADRATIC_SHARE, 2     ; w = this . (point - P)
        .field  QUADRATIC_OUTWARD      ; outside is to the right (1) or left
                                       ; (-1) of the path
        .endrecord

; A row of a lathe's table: a corner of its path, with its height relative to
; the middle, and the segment from the previous corner. Crossings use the
; segment's heights, its direction (1: it rises to this corner) and its line:
;
;   nr r + ny y = k,  nr >= 0
;
; The other fields serve the normal.
        .record LATHE
        .field  LATHE_SQUARE       ; r^2
        .field  LATHE_HEIGHT
        .field  LATHE_BEGINS       ; 1: the path begins here, without a segment
        .field  LATHE_LOW
        .field  LATHE_HIGH
        .field  LATHE_RISES
        .field  LATHE_LINE, 4      ; ny, k, nr^2, nr
        .field  LATHE_RADIUS       ; r
        .field  LATHE_DIRECTION, 2 ; in r and y, of length one
        .field  LATHE_LENGTH
        .field  LATHE_NORMAL, 2    ; outward
        .endrecord

; A row of a blob's table: a component. In its own space its radius is one, its
; base is the origin, and the axis of a cylinder is z.
        .record BLOB
        .field  BLOB_KIND          ; 0: a ball, 1: an ellipsoid, 2: a cylinder
        .field  BLOB_CENTER, 3     ; relative to the blob's centre
        .field  BLOB_SQUARE        ; of a ball's radius
        .field  BLOB_INVERSE       ; reciprocal of BLOB_SQUARE
        .field  BLOB_STRENGTH
        .field  BLOB_LENGTH        ; of a cylinder, in its own space; else 0
        .field  BLOB_MATRIX, 12    ; from the blob's space to its own: rows of
                                   ; three factors and a shift
        .endrecord

; The table of a mesh: a row of zeros except for its last fields, the nodes of a
; hierarchy of boxes in preorder, the triangles, and the windows of the
; viewpoints. A row is identified by its offset in words. A node has two links
; for each combination of signs of a ray's direction (1: x below 0, 2: y, 4: z):
; the next node for rays that come near it, and for other rays. 0 is the end. At
; a leaf the two are equal, but MESH_LEAF_HIT is added to the first. MESH_FIRST
; and MESH_COUNT of the first row are the offset and number of the viewpoints'
; rows (rt/bvh/screen_bounds.h).
        .record MESH
        .field  MESH_BOX, 6        ; centre 3, half sides 3
        .field  MESH_LINKS, 16     ; near, not near; for each of eight signs
        .field  MESH_FIRST         ; of a leaf: its first triangle
        .field  MESH_COUNT         ; of a leaf: number of its triangles
        .at     25              ; odd, against bank conflicts
        .endrecord
        .equ    MESH_LEAF_HIT, 1 << 40

; A viewpoint, and a row of its windows. Nodes are in the same order as above.
        .record VIEWPOINT
        .field  VIEWPOINT_POSITION, 3
        .field  VIEWPOINT_AXIS     ; it looks along x, y, z: 0, 1, 2
        .field  VIEWPOINT_SIGN     ; 1, or -1: down that axis; a number
        .field  VIEWPOINT_FAR      ; windows serve no ray from farther away
        .field  VIEWPOINT_BOUNDS   ; offset of its windows
        .endrecord

        .record SCREEN
        .field  SCREEN_SIDES, 4    ; least and greatest u, then v
        .field  SCREEN_NEAR        ; the least z
        .field  SCREEN_LINKS, 2    ; near, not near
        .field  SCREEN_FIRST       ; as MESH_FIRST
        .field  SCREEN_COUNT       ; as MESH_COUNT; the size is odd, for banks
        .endrecord

        .record TRIANGLE
        .field  TRIANGLE_CORNERS, 9
        .field  TRIANGLE_NORMAL, 3 ; of length one; of a smooth triangle the
                                   ; normal at the first corner, of any length
        .field  TRIANGLE_CHANGE, 9 ; three rows: its change from there
        .endrecord

; A region: a primitive or a Boolean tree of primitives that is traced as a
; unit.
        .record R
        .field  R_BOUND, 5         ; bounding sphere: centre 3, radius, square
                                   ; of the radius; big: no bound
        .field  R_FLAGS            ; REGION_SIMPLE: one primitive whose nearest
                                   ; crossing ahead is the result; REGION_BOXED:
                                   ; with a box; both, or 0
        .field  R_SHADOW           ; 0: casts no shadow, 1: a full one, 2: parts
                                   ; of it are clear
        .field  R_NODES            ; address of its first node
        .field  R_NODES_END        ; address after its last node
        .field  R_FIRST            ; address of its first primitive
        .field  R_RESULT           ; address of the tree's value
        .field  R_CLEAR            ; address of its word in scene_clear, if
                                   ; parts of it are clear
        .field  R_BOX, 6           ; box: centre 3, half sides 3
        .field  R_BODY             ; an integer, 1: inside where its value is 1,
                                   ; -1: where it is 0; 0: open, no inside
        .if     HIDDEN
        .field  R_HIDDEN_FROM      ; sum of the classes of rays that do not see
                                   ; it: IMAGE_RAYS, REFLECTED_RAYS
        .at     21              ; odd, against bank conflicts
        .else
        .at     19              ; odd, against bank conflicts
        .endif
        .endrecord
        .equ    REGION_SIMPLE, 1
        .equ    REGION_BOXED, 2
        .equ    IMAGE_RAYS, 1      ; of the camera, before any reflection
        .equ    REFLECTED_RAYS, 2  ; after a reflection, including a total one

; A node of the hierarchy of regions, in preorder. A leaf has regions. Any other
; node has two child nodes; the first one follows it directly.
        .record H
        .field  H_BOUND, 5         ; as R_BOUND, of all regions below
        .field  H_REGIONS          ; of a leaf: address of its first region;
                                   ; otherwise: of the second child
        .field  H_REGION_COUNT     ; number of regions of a leaf; 0: no leaf
        .field  H_DIRECTION, 3     ; from the first child's centre to the second
        .field  H_SPHERES          ; 1: all regions below are opaque spheres, at
                                   ; most MAX_SPHERES in a leaf
        .at     13              ; odd, against conflicts of gathered fields
        .endrecord
        .equ    HIERARCHY_DEPTH, 96 ; greatest depth of nodes
        .equ    MAX_SPHERES, 8

; A node of a tree, in preorder, without complements. If a ray does not come
; near a node, all nodes below it are skipped and its value is 0. The other
; nodes are active: leaves, and branches, whose steps compute their value from
; their children.
        .record N
        .field  N_BOUND, 5         ; as R_BOUND
        .field  N_STEPS            ; address of its first step
        .field  N_STEP_COUNT       ; number of steps; 0: a leaf, or one child
        .field  N_PRIMITIVE        ; address of a leaf's primitive, or 0
        .field  N_NEEDED           ; 1: rays that miss it miss the tree
        .field  N_NEXT             ; address of the node after those below it
        .field  N_VALUE            ; address of its value
        .if     MESH_CROSSINGS
        .field  N_MESH             ; 1: a mesh is below it
        .endif
        .endrecord

; A step of the evaluation of a tree. The host reserves VALUE_SIZE and
; CROSSING_SIZE words for the values and crossings of the largest tree.
        .record T
        .field  T_OPERATION        ; 0 and, 1 or, 2 and not
        .field  T_LEFT             ; addresses of values
        .field  T_RIGHT
        .field  T_RESULT
        .endrecord

; An active leaf of the current region, in the vector forms.
        .record LEAF
        .field  LEAF_PRIMITIVE
        .field  LEAF_PART, 5       ; P_SEGMENTS .. P_VALUE
        .field  LEAF_NEEDED        ; N_NEEDED
        .endrecord

; An active branch. Branches precede those below them.
        .record BRANCH
        .field  BRANCH_STEPS       ; N_STEPS
        .field  BRANCH_STEP_COUNT
        .endrecord

; A stop of a gradient's map: a colour, and its change up to the next stop. The
; first stop is at -1 and is used until a later one is reached.
        .record STOP
        .field  STOP_AT
        .field  STOP_SLOPE         ; 1 / distance to the next; 0: same place
        .field  STOP_COLOR, 3
        .field  STOP_CHANGE, 3
        .endrecord

; A light.
        .record LIGHT
        .field  LIGHT_POSITION, 3
        .field  LIGHT_COLOR, 3
        .field  LIGHT_HIGHLIGHTS   ; 1: it makes highlights (POV-Ray's
                                   ; shadowless lights make none)
        .if     BEAMS
        .field  LIGHT_BEAM         ; address of its beam, or 0: it shines
                                   ; equally in all directions
        .endif
        .endrecord

; The frame: planes of FRAME_CHANNELS numbers, pixel by pixel, top row first.
        .equ    FRAME_CHANNELS, 8  ; red green blue depth normal 3 id

        .data
; The scene, written by the host.
scene_camera:     .space 12     ; location, direction, right, up
scene_width:      .word 0       ; of the frame, pixels, as numbers
scene_height:     .word 0
scene_background: .space 3
scene_band:       .word 0       ; first row of the traced band, a number
                  .word 0       ; row after its last, a number
scene_first_pixel: .word 0      ; its first pixel in the frame, an integer
scene_pixels:     .word 0       ; pixels of the band, an integer
scene_primitives: .word 0       ; address of the first primitive; their number
scene_primitive_count: .word 0
scene_shared_materials: .word 0 ; 1: some primitives share a material
scene_regions:    .word 0       ; address of the first region
scene_region_count: .word 0     ; regions outside the hierarchy, stored first
scene_region_total: .word 0     ; all regions
scene_hierarchy:  .word 0       ; address of its first node; 0: no hierarchy
scene_clear:      .word 0       ; address of a word for each region with clear
scene_clear_count: .word 0      ; parts, in the order of the scene; their number
scene_leaves:     .word 0       ; LEAF_SIZE words for each leaf of a tree
leaves_end:       .word 0       ; end of the active leaves, by vector code
scene_branches:   .word 0       ; BRANCH_SIZE words for each branch
branches_end:     .word 0       ; end of the active branches, by vector code
scene_levels:     .word 0       ; LEVEL_SIZE words for each level of reflection
scene_level_count: .word 0      ; number of levels: the longest chain of rays; 1
                                ; if nothing reflects or is clear, an integer
scene_bailout:    .word 0       ; rays of smaller weight are dropped, a number
scene_lights:     .word 0       ; address of the first light; their number
scene_light_count: .word 0
scene_frame:      .word 0       ; address of the band's first plane

; Numbers of rays traced, by kind: integers that the host reads.
rays_primary:     .word 0
rays_reflected:   .word 0
rays_refracted:   .word 0
rays_shadow:      .word 0

; The view, computed by camera.s.
        .record VIEW
        .field  VIEW_LOCATION, 3   ; location; orthographic: direction
        .field  VIEW_BASE, 3       ; direction of the ray through the first
                                   ; pixel; orthographic: its origin
        .field  VIEW_COLUMN, 3     ; change of the base per column
        .field  VIEW_ROW, 3        ; change of the base per row
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
k_tiny:         .word 1e-12     ; a ray that approaches a face less is parallel
k_tmin:         .word 1e-6      ; nearer hits are the start of the ray
k_checker:      .word 1e-10     ; added before floor, against ragged faces
        .equ    CONSTANTS, 8       ; constants in registers
k_far:          .word 1e12      ; more distant hits are ignored
k_delta:        .word 1e-7      ; surfaces nearer than this along a ray are one
k_shadow:       .word 1e-3      ; distance of a shadow ray's ends from point and
                                ; light (POV-Ray's SHADOW_TOLERANCE)
k_lower:        .word 1.000000000001e-6 ; tmin to be scaled: a hit beyond it is
                                        ; beyond tmin in world space
k_shadow_lower: .word 1.000000000001e-3 ; k_shadow to be scaled
bound_less:     .word 0.99999999999909050529   ; 1 - 2^-40, in tests of bounds
bound_lost:     .word 0.00000000000090949470   ; 2^-40, in tests of boxes
bound_more:     .word 1.00000000000090949470   ; 1 + 2^-40, where another region
                                               ; may be equally near
        .code
