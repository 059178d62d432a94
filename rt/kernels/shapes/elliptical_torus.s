; elliptical_torus.s - the elliptical torus, by hand in each form.

        shape_by_hand elliptical_torus
