; normal_mesh.s - computes the normal of a mesh (normal_vector.s).

        .kernel shade
        .macro  of_triangle word, into
        address_of table, \word, spare
        gather  point_s, spare, \into
        .endm

        .macro  three_of_triangle word, x, y, z
        of_triangle \word, \x
        of_triangle \word + 1, \y
        of_triangle \word + 2, \z
        .endm

        .macro  find_triangle
        load_point_s
        load_field P_TABLE, table
        three_of_triangle TRIANGLE_NORMAL, nx, ny, nz
        .endm

; Adds to n the product of a row of the matrix TRIANGLE_CHANGE and the point,
; relative to the first corner.
        .macro  interpolate_part row, n
        three_of_triangle TRIANGLE_CHANGE + 3 * \row, t3, t4, t5
        dot_product t0, t1, t2, t3, t4, t5, t6, t7
        plus    t6, \n, \n
        .endm

normal_mesh:
        find_triangle
        leave_normal

; Interpolates the normals of the corners linearly at the point.
normal_smooth_mesh:
        find_triangle
        three_of_triangle TRIANGLE_CORNERS, t3, t4, t5
        three   minus, qx, qy, qz, t3, t4, t5, t0, t1, t2
        interpolate_part 0, nx
        interpolate_part 1, ny
        interpolate_part 2, nz
        BIM     gradient_normal
        .endkernel
