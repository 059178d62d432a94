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
; Out: own_spot_x .., own_face_x .., weight; columns.
; Source: derived here. The area up to l is pi (r^2 - r1^2) divided by the
; normal's ny, or an equivalent.

        .kernel emit
emit_frustum:
        pick_piece 6
        each_times piece2, piece2, toil0
        each_times piece3, piece3, toil1
        each_plus piece2, piece3, toil5
        each_minus toil1, toil0, toil1
        each_times draw0, toil5, toil5
        each_times draw0, toil1, toil1
        each_plus toil1, toil0, toil1
        each_root toil1, toil6                        ; r
        circle  draw1, own_face_z, own_face_x, toil0, toil1, toil2, toil3, toil4
        each_plus piece2, toil6, toil0
        each_over toil5, toil0, toil5                 ; l
        each_times toil6, own_face_x, own_spot_x
        each_times toil6, own_face_z, own_spot_z
        each_times piece4, own_face_x, own_face_x
        each_times piece4, own_face_z, own_face_z
        each_copy piece5, own_face_y
        each_same emission_area, weight
        each_times toil5, piece1, piece1
        each_plus piece1, piece0, own_spot_y
        BIM     emission_carry
        .endkernel
