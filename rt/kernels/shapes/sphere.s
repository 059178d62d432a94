; sphere.s - the sphere, by hand in each form.
;
; Record: centre 3, r^2, 1/r.

        include_form sphere
