; cylinder.s - the cylinder, by hand in each form.

        shape_by_hand cylinder
