; blob.s - the blob, by hand in each form.

        shape_by_hand blob
