; emission.s - computes points of a surface, the normals there and directions in
; which it radiates.
;
; Each point is computed from five numbers in (0, 1). The numbers are those of
; points/points.s, whose constants and inputs apply here too. The scalar form
; computes one point after another, the vector form a queue of points:
;
;   draw0, draw1   position on a piece of the surface
;   draw2, draw3   direction
;   draw4          number of the piece
;
; The kernels of shapes are in these files:
;
;   emit_sphere.s  emit_torus.s  emit_frustum.s  emit_triangle.s
;   emit_steiner_patch.s
;
; Each computes a point, a normal and a weight in object space. It continues
; with carry.s, which continues with cosine_law.s.
;
; In:  emission_arguments: address of an EMISSION.
; Out: emission_results: EMITTED_SIZE planes of POINTS words.
;
; The mean of the weights is the area of the surface.

        .macro  points_done
        .endm
        .include "points/points.s"
        .include "forms.s"

        .record EMISSION
        .field  EMISSION_AREA      ; of the whole surface, or the kernel's
                                   ; factor of weights, times |det M|
        .field  EMISSION_TO_WORLD, 12 ; rows of M, three factors and a shift
        .field  EMISSION_TO_FACE, 9 ; rows of M^-T
        .field  EMISSION_FORM, 24  ; parameters of the shape
        .field  EMISSION_KERNEL    ; address of the kernel
        .field  EMISSION_COUNT     ; number of pieces, an integer
        .field  EMISSION_TABLE     ; address of the columns of pieces (pieces.s)
        .endrecord

        .include "heat/emitted.s"

; Columns: registers of numbers, or of descriptors.
        .equ    EMISSION_WORK, 27
        .regs   r92, local_spot_x, local_spot_y, local_spot_z, local_face_x, local_face_y, local_face_z
        .regs   r98, temp0, temp1, temp2, temp3, temp4, temp5, temp6, temp7, temp8
        .regs   r107, piece0, piece1, piece2, piece3, piece4, piece5, piece6, piece7, piece8, piece9, piece10, piece11
        .regs   r119, draw0, draw1, draw2, draw3, draw4
        .regs   r124, spot_x, spot_y, spot_z, face_x, face_y, face_z, weight, ray_x, ray_y, ray_z
        .regs   spot_x, emitted0, emitted1, emitted2, emitted3, emitted4, emitted5, emitted6, emitted7, emitted8, emitted9

; The words of the EMISSION, in order.
        .regs   r134, emission_area
        .regs   r135, to_world0, to_world1, to_world2, to_world3, to_world4, to_world5, to_world6, to_world7, to_world8, to_world9, to_world10, to_world11
        .regs   r147, to_face0, to_face1, to_face2, to_face3, to_face4, to_face5, to_face6, to_face7, to_face8
        .regs   r156, form0, form1, form2, form3, form4, form5, form6, form7, form8, form9, form10, form11
        .regs   r168, form12, form13, form14, form15, form16, form17, form18, form19, form20, form21, form22, form23
        .regs   r180, emission_kernel, emission_count, emission_table

        .regs   r183, emission_pieces, piece_at, piece_stride
        .regs   r186, emission_link, emission_at, emission_left, emission_plane, emission_stride

        .data
emission_arguments: .word 0
emission_results: .space POINTS * EMITTED_SIZE
        .code

        .include "heat/circle.s"
        .include "heat/pieces.s"

        .ifdef  SCALAR
        .regs   r191, first, second, third
        scalar_form , first, second, third
        .else
        .reg    emission_mask, r90
        .regs   r191, emission_now, emission_high
        vector_form , emission_mask

        .data
emission_bases:
        vector_bases EMISSION_WORK, emission_store
emission_descriptors:
        .space  EMISSION_WORK
emission_bits:  .space (QUEUE + 63) / 64
        .align  64
emission_store: .space QUEUE * EMISSION_WORK
        .code

; Makes descriptors of `count` planes in `register`, from the next point on and
; as long as the queue.
        .macro  emission_planes planes, count, register
        EX      emission_plane, \planes
        ADDX    emission_plane, emission_at, emission_plane
        ADDLEN  emission_plane, emission_now, emission_plane
        .rept   \count
        RTOR    emission_plane, \register
        ADDX    emission_plane, emission_stride, emission_plane
        .endr
        .endm
        .endif

        .kernel begin
        load_word emission_arguments, emission_plane
        load_from emission_plane, EMISSION_SIZE, emission_area
        circle_load emission_plane
        ADDN    emission_count, r0, emission_pieces
        SHIFTI  emission_count, 6, piece_stride
        EX      emission_stride, 64 * POINTS
        EX      emission_left, POINTS
        ES      emission_at, 0
        .endkernel

emission_next:
        .kernel queue
        .ifdef  SCALAR
        EX      emission_plane, points_results
        .rept   STREAM_DRAWS
        LOD     [emission_plane, emission_at], draw\+
        ADDX    emission_plane, emission_stride, emission_plane
        .endr
        BSAVE   emission_link, [emission_kernel]
        EX      emission_plane, emission_results
        .rept   EMITTED_SIZE
        STO     [emission_plane, emission_at], emitted\+
        ADDX    emission_plane, emission_stride, emission_plane
        .endr
        IBXNE   emission_at, stream_one, emission_left, emission_next, emission_at
        .else
        RTOR    points_queue, emission_now
        IBXGE   emission_left, r0, points_queue, emission_full
        RTOR    emission_left, emission_now
emission_full:
        lengthen_table emission_bases, emission_descriptors, EMISSION_WORK, emission_now, emission_plane, piece_at, emission_high
        SWAP    [piece_at], local_spot_x, [r0]
        describe emission_mask, emission_bits, emission_now
        emission_planes points_results, STREAM_DRAWS, draw\+
        emission_planes emission_results, EMITTED_SIZE, emitted\+
        BSAVE   emission_link, [emission_kernel]
        advance_by emission_at, emission_now, emission_high
        SUBX    emission_left, emission_now, emission_left
        IBXNE   emission_left, r0, r0, emission_next
        .endif
        EXIT
        .endkernel

        .include "heat/emit_sphere.s"
        .include "heat/emit_torus.s"
        .include "heat/emit_frustum.s"
        .include "heat/emit_triangle.s"
        .include "heat/emit_steiner_patch.s"
        .include "heat/carry.s"
        .include "heat/cosine_law.s"
        .kernel direction
        BIM     0, emission_link
        .endkernel
