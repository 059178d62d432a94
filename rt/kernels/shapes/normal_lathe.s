; normal_lathe.s - the normal of a lathe, by hand in each form.

        by_hand lathe
