; emission_kernels.s - includes all kernels of emission and their common end.

        .include "heat/emit_sphere.s"
        .include "heat/emit_torus.s"
        .include "heat/emit_frustum.s"
        .include "heat/emit_triangle.s"
        .include "heat/emit_steiner_patch.s"
        .include "heat/carry.s"
        .include "heat/cosine_law.s"
        .kernel direction
        BIM     0, emission_link
        .endkernel
