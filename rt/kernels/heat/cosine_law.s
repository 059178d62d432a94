; cosine_law.s - directions in which a diffuse surface radiates.
;
; A direction is in a part of the half space above the surface with a
; probability proportional to the area of the part's vertical projection on the
; unit disc. The vector (x, y, z) with
;
;   r = sqrt u,  x = r cos 2 pi t,  y = r sin 2 pi t,  z = sqrt (1 - u)
;
; is rotated so that z points along the normal n. With s = 1, or s = -1 if nz is
; below 0:
;
;   q = x nx + y ny,   g = z - q / (s + nz),
;   D = (s x + g nx,  s y + g ny,  z nz - q)
;
; In:  face_x, face_y, face_z: n, of length one; draw2: u, draw3: t; columns.
; Out: ray_x, ray_y, ray_z: D, of length one.
; Source: J. H. Lambert, Photometria (1760). The frame is that of T. Duff and
; others, "Building an orthonormal basis, revisited" (2017), worked out for one
; vector.

        .kernel direction
emission_direction:
        each_root draw2, temp5                        ; r
        each_from each_one, draw2, temp6
        circle  draw3, ray_y, ray_x, temp0, temp1, temp2, temp3, temp4
        each_root temp6, temp6                        ; z
        each_times temp5, ray_x, ray_x
        each_times temp5, ray_y, ray_y
        each_sign face_z, temp2
        each_times ray_x, face_x, temp3
        each_times ray_y, face_y, temp4
        each_plus temp2, face_z, temp0
        each_times temp2, ray_x, ray_x
        each_times temp2, ray_y, ray_y
        each_plus temp3, temp4, temp3                 ; q
        each_over temp3, temp0, temp0
        each_times temp6, face_z, ray_z
        each_minus ray_z, temp3, ray_z
        each_minus temp6, temp0, temp6                ; g
        each_times temp6, face_x, temp3
        each_times temp6, face_y, temp4
        each_plus ray_x, temp3, ray_x
        each_plus ray_y, temp4, ray_y
        .endkernel
