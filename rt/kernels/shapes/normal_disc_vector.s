; normal_disc_vector.s - the normals of discs are those of
; normal_plane_vector.s.
