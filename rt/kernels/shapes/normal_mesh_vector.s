; normal_mesh_vector.s - computes the normals of meshes (normal_vector.s).

        .kernel shade

; [into] = word number of the rows of the hit triangles; s1 = the table.
        .macro  of_triangle number, into
        RTOR    s1, s0
        IX      s0, 64 * (\number)
        VXTOV   [cr], [s0], [\into]
        .endm

        .macro  find_triangles
        VXTOV   [at], [hit_s], [cr]
        load_field P_TABLE, s1
        of_triangle TRIANGLE_NORMAL, nx
        of_triangle TRIANGLE_NORMAL + 1, ny
        of_triangle TRIANGLE_NORMAL + 2, nz
        .endm

; Adds to [n] the product of a row of the matrix TRIANGLE_CHANGE and the point,
; relative to the first corner.
        .macro  change_normal row, n
        of_triangle TRIANGLE_CHANGE + 3 * \row, v3
        of_triangle TRIANGLE_CHANGE + 3 * \row + 1, v4
        of_triangle TRIANGLE_CHANGE + 3 * \row + 2, v5
        dot_vectors v0, v1, v2, v3, v4, v5, v6, v7
        ADDNV   [v6], [\n], [\n]
        .endm

normal_mesh:
        find_triangles
        BIM     0, link_kernel

; Interpolates the normals of the corners linearly at the point.
normal_smooth_mesh:
        find_triangles
        of_triangle TRIANGLE_CORNERS, v3
        of_triangle TRIANGLE_CORNERS + 1, v4
        of_triangle TRIANGLE_CORNERS + 2, v5
        SUBNV   [qx], [v3], [v0]
        SUBNV   [qy], [v4], [v1]
        SUBNV   [qz], [v5], [v2]
        change_normal 0, nx
        change_normal 1, ny
        change_normal 2, nz
        BIM     gradient_normal
        .endkernel
