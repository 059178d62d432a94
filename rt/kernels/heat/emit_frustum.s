; emit_frustum.s - points of surfaces of revolution with straight outlines.
;
; These are the sides of cylinders and cones, discs and rings about the y axis.
; Points are distributed uniformly over the area. A piece begins at height y0
; and radius r1 and ends at y0 + h and r2:
;
;   r = sqrt (r1^2 + u (r2^2 - r1^2)),  l = u (r1 + r2) / (r1 + r)
;   P = (r cos 2 pi t,  y0 + l h,  r sin 2 pi t)
;   n = (nr cos 2 pi t,  ny,  nr sin 2 pi t)
;
; l is the fraction of its length. It equals (r - r1) / (r2 - r1), but is u
; where the radii are equal.
;
; In:  draw0: u, draw1: t; draw4 and the table: pieces of y0, h, r1, r2, nr,
;      ny; emission_area.
; Out: local_spot_x .., local_face_x .., weight; columns.
; Source: derived here. The area up to l is pi (r^2 - r1^2) divided by the
; normal's ny, or an equivalent.

        .kernel emit
emit_frustum:
        pick_piece 6
        times   piece2, piece2, temp0
        times   piece3, piece3, temp1
        plus    piece2, piece3, temp5
        minus   temp1, temp0, temp1
        times   draw0, temp5, temp5
        times   draw0, temp1, temp1
        plus    temp1, temp0, temp1
        root    temp1, temp6                    ; r
        circle  draw1, local_face_z, local_face_x, local_spot_x
        plus    piece2, temp6, temp0
        quotient temp5, temp0, temp5            ; l
        times   temp6, local_face_x, local_spot_x
        times   temp6, local_face_z, local_spot_z
        times   piece4, local_face_x, local_face_x
        times   piece4, local_face_z, local_face_z
        copy    piece5, local_face_y
        set     emission_area, weight
        times   temp5, piece1, piece1
        plus    piece1, piece0, local_spot_y
        BIM     emission_transform
        .endkernel
