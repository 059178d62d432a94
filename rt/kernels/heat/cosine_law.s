; cosine_law.s - directions in which a diffuse surface radiates: into a part of the
; half space above it as often as that part's shadow, straight down on the surface,
; covers of the unit disc there.
;
;   r = sqrt u,  x = r cos 2 pi t,  y = r sin 2 pi t,  z = sqrt (1 - u)
;
; is turned so that z points along the normal n; with s = 1, or -1 where nz is below 0,
;
;   q = x nx + y ny,   g = z - q / (s + nz),
;   D = (s x + g nx,  s y + g ny,  z nz - q).
;
; In:  face_x, face_y, face_z: n, of length one; draw2: u, draw3: t; columns.
; Out: ray_x, ray_y, ray_z: D, of length one.
; Source: J. H. Lambert, Photometria (1760); the frame is that of T. Duff and others,
; "Building an orthonormal basis, revisited" (2017), worked out for one vector.

        .kernel direction
emission_direction:
        column_root draw2, toil5                        ; r
        column_from column_one, draw2, toil6
        circle  draw3, ray_y, ray_x, toil0, toil1, toil2, toil3, toil4
        column_root toil6, toil6                        ; z
        column_times toil5, ray_x, ray_x
        column_times toil5, ray_y, ray_y
        column_sign face_z, toil2
        column_times ray_x, face_x, toil3
        column_times ray_y, face_y, toil4
        column_plus toil2, face_z, toil0
        column_times toil2, ray_x, ray_x
        column_times toil2, ray_y, ray_y
        column_plus toil3, toil4, toil3                 ; q
        column_over toil3, toil0, toil0
        column_times toil6, face_z, ray_z
        column_minus ray_z, toil3, ray_z
        column_minus toil6, toil0, toil6                ; g
        column_times toil6, face_x, toil3
        column_times toil6, face_y, toil4
        column_plus ray_x, toil3, ray_x
        column_plus ray_y, toil4, ray_y
        .endkernel
