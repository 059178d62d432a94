; normal_cone.s - the normal of a cone, by hand in each form.

        by_hand cone
