; cone.s - the cone, by hand in each form.

        shape_by_hand cone
