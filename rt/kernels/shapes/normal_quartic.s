; normal_quartic.s - the normal of a quartic, by hand in each form.

        by_hand quartic
