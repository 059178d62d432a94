; normal_elliptical_torus_vector.s - the normals are those of
; normal_torus_vector.s.
