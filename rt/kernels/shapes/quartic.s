; quartic.s - the quartic, by hand in each form.

        include_form quartic
