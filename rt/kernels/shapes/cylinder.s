; cylinder.s - the cylinder, by hand in each form.
;
; Record: centre 3, unit axes u 3, v 3, w 3 (along), r^2, half length, 1/(2
;         r), 1/r.  Of 1984: base 3, unit axis 3, r, planes of base and cap,
;         each p 3 and q, outside p . X + q > 0, 1/r.

        include_form cylinder

        .ifdef  CYLINDER_IN_FRAME
        .include "shapes/cylinder_in_frame.s"
        .endif

        .ifdef  HISTORICAL
        .include "shapes/cylinder_clipped.s"
        .endif
