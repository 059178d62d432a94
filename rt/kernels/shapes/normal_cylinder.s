; normal_cylinder.s - the normal of a cylinder, by hand in each form.

        by_hand cylinder
