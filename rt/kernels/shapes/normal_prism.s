; normal_prism.s - the normal of a prism, by hand in each form.

        by_hand prism
