; intersect_vector.s - the kernels by which a queue of rays meets primitives, for
; the frame in vector form and for that of 1984: the way to the rays that come
; near, each shape, the root solver.

        .include "frame/bound_vector.s"
        .include "frame/regions_vector.s"
        .include "solids/nodes_vector.s"
        .include "solids/few_vector.s"
        .include "shapes/slab_vector.s"
        .include "shapes/sphere_vector.s"
        .include "shapes/box_vector.s"
        .include "shapes/quadratic_vector.s"
        .include "shapes/cylinder_vector.s"
        .include "shapes/cone_vector.s"
        .include "shapes/quadric_vector.s"
        .include "shapes/plane_vector.s"
        .include "roots/quartic_vector.s"
        .include "shapes/lanes_vector.s"
        .include "solids/segments_vector.s"
        .include "shapes/torus_vector.s"
        .include "shapes/quartic_terms.s"
        .include "shapes/quartic_surface_vector.s"
        .include "shapes/steiner_constants.s"
        .include "shapes/steiner_vector.s"
        .ifdef  HISTORICAL
        .include "shapes/steiner_implicit_vector.s"
        .endif
        .include "frame/transform_vector.s"
