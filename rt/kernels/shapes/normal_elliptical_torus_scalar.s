; normal_elliptical_torus_scalar.s - the routine of normal_torus_scalar.s.
