; torus.s - the torus, by hand in each form.

        shape_by_hand torus
