; lathe.s - the lathe, by hand in each form.

        shape_by_hand lathe
