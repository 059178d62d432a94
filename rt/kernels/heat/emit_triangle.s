; emit_triangle.s - uniform points of triangles, for meshes and for boxes.
;
;   s = sqrt u,   P = C + (s - s t) A + s t B
;
; In:  draw0: u, draw1: t; draw4 and the table: pieces of a corner C, the edges
;      A and B from there, the normal, of length one, 3 words each;
;      emission_area.
; Out: local_spot_x .., local_face_x .., weight; columns.
; Source: G. Turk, "Generating random points in triangles", Graphics Gems
; (1990).

        .macro  triangle_axis corner, first, second, normal, axis
        times   temp0, \first, \first
        times   temp1, \second, \second
        plus    \first, \corner, \first
        plus    \first, \second, local_spot_\axis
        copy    \normal, local_face_\axis
        .endm

        .kernel emit
emit_triangle:
        pick_piece 12
        root    draw0, temp0                    ; s
        times   temp0, draw1, temp1
        minus   temp0, temp1, temp0
        triangle_axis piece0, piece3, piece6, piece9, x
        triangle_axis piece1, piece4, piece7, piece10, y
        triangle_axis piece2, piece5, piece8, piece11, z
        set     emission_area, weight
        BIM     emission_transform
        .endkernel
