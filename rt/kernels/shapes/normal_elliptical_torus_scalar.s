; normal_elliptical_torus_scalar.s - the normal is that of
; normal_torus_scalar.s.
