; normal_elliptical_torus_vector.s - the routine of normal_torus_vector.s.
