; intersect_vector.s - the kernels by which a queue of rays meets primitives, for
; the frame in vector form and for that of 1984: the way to the rays that come
; near, each shape, the root solver.

        .include "frame/bound_vector.s"
        .include "frame/regions_vector.s"
        .include "frame/miss_box_vector.s"
        .include "frame/hierarchy_vector.s"
        .include "solids/nodes_vector.s"
        .include "solids/sparse_vector.s"
        .include "shapes/slab_vector.s"
        .include "shapes/quadratic_vector.s"
        .include "shapes/every_vector.s"
        .include "frame/transform_vector.s"
