; normal_disc_scalar.s - the normal of a disc is that of normal_plane_scalar.s.
