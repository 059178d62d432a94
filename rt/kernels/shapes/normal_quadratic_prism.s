; normal_quadratic_prism.s - the normal of a quadratic prism, by hand in each form.

        by_hand quadratic_prism
