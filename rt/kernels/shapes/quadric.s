; quadric.s - the quadric, by hand in each form.

        shape_by_hand quadric
