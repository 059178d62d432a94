; normal_disc.s - the normal of a disc is that of normal_plane.s.
