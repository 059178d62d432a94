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
; Out: local_spot_x .., local_face_x .., weight; columns.
; Source: textbook, dP/du x dP/dt.

        .kernel emit
emit_torus:
        circle  draw0, local_face_y, local_spot_y, temp5
        circle  draw1, local_face_z, local_face_x, temp5
        scale   local_spot_y, form1, temp0
        scale   local_spot_y, form2, temp1
        scale   local_face_y, form2, local_spot_y
        scale   local_face_y, form1, local_face_y
        raise   temp0, form0, temp0             ; rho
        times   temp0, local_face_x, local_spot_x
        times   temp0, local_face_z, local_spot_z
        times   temp1, local_face_x, local_face_x
        times   temp1, local_face_z, local_face_z
        scale   temp0, emission_area, weight
        BIM     emission_transform
        .endkernel
