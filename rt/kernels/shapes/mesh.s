; mesh.s - the mesh, by hand in each form.

        include_form mesh
