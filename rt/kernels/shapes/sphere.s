; sphere.s - the sphere, by hand in each form.

        include_form sphere
