; emit_torus.s - points of a torus about the y axis.
;
; Its tube is an ellipse at the distance R, with half axes a away from the axis
; and b along it.
;
;   rho = R + a cos 2 pi u,
;   P = (rho cos 2 pi t,  b sin 2 pi u,  rho sin 2 pi t)
;   n = (b cos 2 pi u cos 2 pi t,  a sin 2 pi u,  b cos 2 pi u sin 2 pi t)
;   w = 4 pi^2 rho |n|
;
; The normal does not have length one. Its length becomes a factor of the weight
; when both are transformed to world space.
;
; In:  draw0: u, draw1: t; form0: R, form1: a, form2: b; emission_area: 4 pi^2
;      times |det M|.
; Out: own_spot_x .., own_face_x .., weight; columns.
; Source: textbook, dP/du x dP/dt.

        .kernel emit
emit_torus:
        circle  draw0, own_face_y, own_spot_y, toil0, toil1, toil2, toil3, toil4
        circle  draw1, own_face_z, own_face_x, toil0, toil1, toil2, toil3, toil4
        each_scale own_spot_y, form1, toil0
        each_scale own_spot_y, form2, toil1
        each_scale own_face_y, form2, own_spot_y
        each_scale own_face_y, form1, own_face_y
        each_shift toil0, form0, toil0                ; rho
        each_times toil0, own_face_x, own_spot_x
        each_times toil0, own_face_z, own_spot_z
        each_times toil1, own_face_x, own_face_x
        each_times toil1, own_face_z, own_face_z
        each_scale toil0, emission_area, weight
        BIM     emission_carry
        .endkernel
