; blob.s - the blob, by hand in each form.

        include_form blob
