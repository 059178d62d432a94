; torus.s - the torus, by hand in each form.

        include_form torus
