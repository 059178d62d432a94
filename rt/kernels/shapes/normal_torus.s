; normal_torus.s - computes the normal of a torus of any kind (normal_vector.s).

        .kernel shade
; The normal is the gradient of (x^2 + z^2 + rho y^2 + b0)^2 - a0 (x^2 + z^2).
; With g = x^2 + z^2 + rho y^2 + b0:  N = ((g - a0/2) x, rho g y, (g - a0/2) z).
normal_torus:
        load_shape 4
        times   qx, qx, t0
        times   qz, qz, t1
        plus    t1, t0, t0
        times   qy, qy, t1
        scaled_plus t1, sh0, t0, t0
        raise   t0, sh1, t0                     ; g
        times   t0, qy, t1
        scale   t1, sh0, ny
        lower   t0, sh3, t0
        times   t0, qx, nx
        times   t0, qz, nz
        BIM     gradient_normal
        .endkernel
