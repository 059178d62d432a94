; intersect_vector.s - includes the kernels that intersect queues of rays.
;
; They select the rays that come near a region, intersect shapes and solve for
; roots. The vector form and the kernels mode use them.

        .include "frame/bound_vector.s"
        .include "frame/regions_vector.s"
        .include "frame/miss_box_vector.s"
        .include "frame/hierarchy_vector.s"
        .include "solids/nodes_vector.s"
        .include "solids/sparse_vector.s"
        .include "shapes/forms_vector.s"
        .include "shapes/every.s"
        .include "frame/transform_vector.s"
