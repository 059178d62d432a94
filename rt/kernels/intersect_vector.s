; intersect_vector.s - the kernels by which a queue of rays meets primitives, for
; the frame in vector form and for that of 1984: the way to the rays that come
; near, each shape, the root solver.

        .include "bound_vector.s"
        .include "regions_vector.s"
        .include "nodes_vector.s"
        .include "few_vector.s"
        .include "slab_vector.s"
        .include "sphere_vector.s"
        .include "box_vector.s"
        .include "quadratic_vector.s"
        .include "cylinder_vector.s"
        .include "cone_vector.s"
        .include "quadric_vector.s"
        .include "plane_vector.s"
        .include "quartic_vector.s"
        .include "lanes_vector.s"
        .include "segments_vector.s"
        .include "torus_vector.s"
        .include "quartic_terms.s"
        .include "quartic_surface_vector.s"
        .include "steiner_constants.s"
        .include "steiner_vector.s"
        .ifdef  HISTORICAL
        .include "steiner_implicit_vector.s"
        .endif
        .include "transform_vector.s"
