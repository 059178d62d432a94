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
        each_root draw2, toil5                        ; r
        each_from each_one, draw2, toil6
        circle  draw3, ray_y, ray_x, toil0, toil1, toil2, toil3, toil4
        each_root toil6, toil6                        ; z
        each_times toil5, ray_x, ray_x
        each_times toil5, ray_y, ray_y
        each_sign face_z, toil2
        each_times ray_x, face_x, toil3
        each_times ray_y, face_y, toil4
        each_plus toil2, face_z, toil0
        each_times toil2, ray_x, ray_x
        each_times toil2, ray_y, ray_y
        each_plus toil3, toil4, toil3                 ; q
        each_over toil3, toil0, toil0
        each_times toil6, face_z, ray_z
        each_minus ray_z, toil3, ray_z
        each_minus toil6, toil0, toil6                ; g
        each_times toil6, face_x, toil3
        each_times toil6, face_y, toil4
        each_plus ray_x, toil3, ray_x
        each_plus ray_y, toil4, ray_y
        .endkernel
