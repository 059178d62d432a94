; normal_blob.s - the normal of a blob, by hand in each form.

        by_hand blob
