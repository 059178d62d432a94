; spots.s - makes radiating points of a surface from its crossings with lines.
;
; The lines are isotropic and uniform, so the points are uniform over the
; surface and the directions follow the cosine law on both sides of it. A
; crossing at the distance t along its line makes the point o + t d with the
; direction d and the normal -n. The crossing's normal n is against the line. If
; the line enters a body there, the direction and the normal point inward, and
; faces.s reverses them.
;
; In:  the words below.
; Out: spots_results: EMITTED_SIZE planes, a word for each crossing.
; Source: M. Sbert, "An integral geometry based method for fast form-factor
; computation" (1993).

        .include "points/planes.s"
        .include "heat/emitted.s"

        .record CROSSED                 ; a crossing's words: planes
        .field  CROSSED_DISTANCE        ; from the origin of its line
        .field  CROSSED_LINE            ; number of the line, an integer
        .field  CROSSED_NORMAL, 3       ; of length one, against the line
        .endrecord

        .data
spots_arguments:
spots_lines:    .word 0                 ; number of lines, an integer
spots_crossings: .word 0                ; crossings, 1 .. 65535, an integer
spots_from:     .word 0                 ; address of the lines' EMITTED planes
spots_list:     .word 0                 ; address of the planes of crossings
spots_results:  .word 0                 ; address of the results
spots_weight:   .word 0.0               ; an area
                .word 1
                .equ    SPOTS_ARGUMENTS, 7
        .code

        .regs   r10, spot_lines, spot_count, spot_from, spot_list, spot_results, spot_weight, spot_one
        .regs   r17, spot_line_stride, spot_stride, spot_work
        .regs   r20, spot_origin, spot_direction ; planes of the lines
        .regs   r22, spot_distance, spot_line, spot_normal
        .regs   r25, result_spot, result_face, result_weight, result_ray

; Computes the address of a field's plane. The distance between planes is
; `stride`.
        .macro  plane_at base, stride, field, into
        ES      spot_work, \field
        MPYX    spot_work, \stride, spot_work
        ADDX    \base, spot_work, \into
        .endm

        .regs   r30, line, distance, spot, ray, origin, normal, face, spot_i, spot_bits

        planes  spot_i, spot_one, spot_count, spot_work, spot_bits

; Computes one axis of the points, directions and normals.
        .macro  spots_axis
        each    spots_next\@
        fetch   spot_line, line
        fetch   spot_distance, distance
        plane   result_ray, ray
        plane   result_spot, spot
        gather  line, spot_direction, ray
        gather  line, spot_origin, origin
        times   distance, ray, spot
        plus    origin, spot, spot
        store   ray, result_ray
        store   spot, result_spot
        load    spot_normal, normal
        plane   result_face, face
        from    r0, normal, face
        store   face, result_face
        next    spots_next\@
        .endm

; Advances to the planes of the next axis.
        .macro  spots_advance
        ADDX    spot_origin, spot_line_stride, spot_origin
        ADDX    spot_direction, spot_line_stride, spot_direction
        ADDX    spot_normal, spot_stride, spot_normal
        ADDX    result_spot, spot_stride, result_spot
        ADDX    result_face, spot_stride, result_face
        ADDX    result_ray, spot_stride, result_ray
        .endm

        .entry  spots
        .kernel spots
spots:
        load_words spots_arguments, SPOTS_ARGUMENTS, spot_lines, spot_work
        SHIFTI  spot_lines, 6, spot_line_stride
        SHIFTI  spot_count, 6, spot_stride
        plane_at spot_from, spot_line_stride, EMITTED_POINT, spot_origin
        plane_at spot_from, spot_line_stride, EMITTED_RAY, spot_direction
        plane_at spot_list, spot_stride, CROSSED_DISTANCE, spot_distance
        plane_at spot_list, spot_stride, CROSSED_LINE, spot_line
        plane_at spot_list, spot_stride, CROSSED_NORMAL, spot_normal
        plane_at spot_results, spot_stride, EMITTED_POINT, result_spot
        plane_at spot_results, spot_stride, EMITTED_FACE, result_face
        plane_at spot_results, spot_stride, EMITTED_WEIGHT, result_weight
        plane_at spot_results, spot_stride, EMITTED_RAY, result_ray
        plane   spot_line, line
        plane   spot_distance, distance
        plane   result_weight, origin   ; until the weights are known
        spots_axis
        spots_advance
        spots_axis
        spots_advance
        spots_axis
        each    spots_weigh
        fill    spot_weight, result_weight, origin
        next    spots_weigh
        EXIT
        .endkernel
