; cylinder.s - the cylinder, by hand in each form.

        include_form cylinder

        .ifdef  CYLINDER_IN_FRAME
        .include "shapes/cylinder_in_frame.s"
        .endif

        .ifdef  HISTORICAL
        .include "shapes/cylinder_clipped.s"
        .endif
