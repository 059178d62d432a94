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
        root    draw2, temp5                    ; r
        from    one, draw2, temp6
        circle  draw3, ray_y, ray_x, ray_z
        root    temp6, temp6                    ; z
        times   temp5, ray_x, ray_x
        times   temp5, ray_y, ray_y
        sign    face_z, one, minus_one, temp2
        times   ray_x, face_x, temp3
        times   ray_y, face_y, temp4
        plus    temp2, face_z, temp0
        times   temp2, ray_x, ray_x
        times   temp2, ray_y, ray_y
        plus    temp3, temp4, temp3             ; q
        quotient temp3, temp0, temp0
        times   temp6, face_z, ray_z
        minus   ray_z, temp3, ray_z
        minus   temp6, temp0, temp6             ; g
        times   temp6, face_x, temp3
        times   temp6, face_y, temp4
        plus    ray_x, temp3, ray_x
        plus    ray_y, temp4, ray_y
        .endkernel
