; normal_elliptical_torus.s - the normal is that of normal_torus.s.
