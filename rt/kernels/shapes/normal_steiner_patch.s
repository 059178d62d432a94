; normal_steiner_patch.s - the normal of a Steiner patch, by hand in each form.

        by_hand steiner_patch
