; emit_steiner_patch.s - points of a Steiner patch, uniform in its parameters.
;
; The weight is the size of the area element on the patch.
;
;   g = sqrt u,  p = g - g t,  q = g t
;   X_i = k0 + k1 p + k2 q + k3 p^2 + k4 p q + k5 q^2,  i = x y z, also W
;   P = X / W
;   n = (X_p - P W_p) x (X_q - P W_q) / W^2 = dP/dp x dP/dq
;   w = |n| / 2
;
; The normal does not have length one. Its length becomes a factor of the weight
; when both are transformed to world space. A patch has no outside: the normal
; is on one side of it.
;
; In:  draw0: u, draw1: t; form0 .. form23: k0, k1, k2, 2 k3, k4, 2 k5 of x, y,
;      z, w; emission_area: |det M| / 2.
; Out: local_spot_x .., local_face_x .., weight; columns.
; Source: textbook; rt/shapes/patch.h defines patches.

; Computes the polynomial, and its derivatives by p in `along`, by q in
; `across`.
        .macro  patch_polynomial k0, k1, k2, k3, k4, k5, value, along, across
        scale   temp0, \k3, \along
        scale   temp0, \k4, \across
        raise   \along, \k1, \along
        raise   \across, \k2, \across
        scaled_plus_two temp1, \k4, \along, \along, temp1, \k5, \across, \across ; X_p, X_q
        raise   \along, \k1, temp2
        raise   \across, \k2, temp3
        times   temp2, temp0, temp2
        times   temp3, temp1, temp3
        plus    temp2, temp3, temp2
        scale   temp2, half, temp2
        raise   temp2, \k0, \value
        .endm

; Computes the coordinate of the point from `value`, and W times its derivatives
; in `along` and `across`.
        .macro  patch_divided value, along, across
        times   \value, piece9, \value
        times   \value, piece10, temp0
        times   \value, piece11, temp1
        minus   \along, temp0, \along
        minus   \across, temp1, \across
        .endm

        .macro  patch_normal a0, b1, a1, b0, normal
        times   \a0, \b1, \normal
        times   \a1, \b0, temp0
        minus   \normal, temp0, \normal
        times   \normal, temp1, \normal
        .endm

        .kernel emit
emit_steiner_patch:
        root    draw0, temp0
        times   temp0, draw1, temp1             ; q
        minus   temp0, temp1, temp0             ; p
        patch_polynomial form0, form1, form2, form3, form4, form5, local_spot_x, piece0, piece1
        patch_polynomial form6, form7, form8, form9, form10, form11, local_spot_y, piece2, piece3
        patch_polynomial form12, form13, form14, form15, form16, form17, local_spot_z, piece4, piece5
        patch_polynomial form18, form19, form20, form21, form22, form23, piece9, piece10, piece11
        into    one, piece9, piece9
        patch_divided local_spot_x, piece0, piece1
        patch_divided local_spot_y, piece2, piece3
        patch_divided local_spot_z, piece4, piece5
        times   piece9, piece9, temp1
        patch_normal piece2, piece5, piece4, piece3, local_face_x
        patch_normal piece4, piece1, piece0, piece5, local_face_y
        patch_normal piece0, piece3, piece2, piece1, local_face_z
        set     emission_area, weight
        BIM     emission_transform
        .endkernel
