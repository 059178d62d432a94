; carry.s - transforms an emitted point and its normal to world space.
;
; A kernel of emission computes them in object space. M is the matrix, m the
; shift:
;
;   P' = M P + m,   N = M^-T n,   n' = N / |N|,   w' = w |N|
;
; An area grows by the factor |det M| |N|. The weight w contains |det M|.
;
; In:  local_spot_x .., local_face_x .., weight; to_world: rows of M, each followed
;      by its part of m; to_face: rows of M^-T.
; Out: spot_x .., face_x .., of length one; weight.
; Continues with the direction (cosine_law.s).
; Source: textbook.

        .macro  transform_rows x, y, z, k00, k01, k02, k10, k11, k12, k20, k21, k22, to0, to1, to2
        three_by scale, \x, \k00, \k10, \k20, \to0, \to1, \to2
        scaled_plus_three \y, \k01, \to0, \to0, \y, \k11, \to1, \to1, \y, \k21, \to2, \to2
        scaled_plus_three \z, \k02, \to0, \to0, \z, \k12, \to1, \to1, \z, \k22, \to2, \to2
        .endm

        .kernel carry
emission_transform:
        transform_rows local_face_x, local_face_y, local_face_z, to_face0, to_face1, to_face2, to_face3, to_face4, to_face5, to_face6, to_face7, to_face8, face_x, face_y, face_z
        times   face_x, face_x, temp0
        times   face_y, face_y, temp1
        times   face_z, face_z, temp2
        plus    temp0, temp1, temp0
        plus    temp0, temp2, temp0
        root    temp0, temp0                    ; N|
        transform_rows local_spot_x, local_spot_y, local_spot_z, to_world0, to_world1, to_world2, to_world4, to_world5, to_world6, to_world8, to_world9, to_world10, spot_x, spot_y, spot_z
        raise   spot_x, to_world3, spot_x
        raise   spot_y, to_world7, spot_y
        raise   spot_z, to_world11, spot_z
        into    one, temp0, temp1
        times   weight, temp0, weight
        three_by times, temp1, face_x, face_y, face_z, face_x, face_y, face_z
        .endkernel
