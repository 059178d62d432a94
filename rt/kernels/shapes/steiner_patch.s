; steiner_patch.s - the steiner patch, by hand in each form.

        shape_by_hand steiner_patch
