; sphere.s - the sphere, by hand in each form.

        shape_by_hand sphere
