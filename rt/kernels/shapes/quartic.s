; quartic.s - the quartic, by hand in each form.

        shape_by_hand quartic
