; cylinder.s - the cylinder, by hand in each form.

        include_form cylinder
