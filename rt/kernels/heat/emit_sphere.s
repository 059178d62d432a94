; emit_sphere.s - uniform points of the unit sphere about the origin.
;
;   z = 1 - 2 u,  r = 2 sqrt (u (1 - u)),
;   P = n = (r cos 2 pi t, z, r sin 2 pi t)
;
; In:  draw0: u, draw1: t; emission_area.
; Out: local_spot_x .., local_face_x .., weight; columns.
; Source: Archimedes, On the sphere and cylinder: the area of a slice is
; proportional to its height.

        .kernel emit
emit_sphere:
        from    one, draw0, temp0
        times   draw0, temp0, temp5
        minus   temp0, draw0, local_spot_y
        root    temp5, temp5
        circle  draw1, local_spot_z, local_spot_x, temp6
        plus    temp5, temp5, temp5             ; r
        times   temp5, local_spot_x, local_spot_x
        times   temp5, local_spot_z, local_spot_z
        copy    local_spot_x, local_face_x
        copy    local_spot_y, local_face_y
        copy    local_spot_z, local_face_z
        set     emission_area, weight
        BIM     emission_transform
        .endkernel
