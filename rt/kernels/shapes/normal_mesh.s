; normal_mesh.s - the normal of a mesh, by hand in each form.

        by_hand mesh
