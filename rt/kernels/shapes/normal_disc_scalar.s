; normal_disc_scalar.s - the normal of a disc: its plane's (normal_plane_scalar.s).
