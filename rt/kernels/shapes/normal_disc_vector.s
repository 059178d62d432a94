; normal_disc_vector.s - the normals of discs: their planes' (normal_plane_vector.s).
