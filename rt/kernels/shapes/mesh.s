; mesh.s - the mesh, by hand in each form.

        shape_by_hand mesh
