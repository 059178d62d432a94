; normal_box.s - the normal of a box, by hand in each form.

        by_hand box
