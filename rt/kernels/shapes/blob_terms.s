; blob_terms.s - computes the field of a blob on an interval of a ray, for the
; scalar and the vector form.  blob_vector.s has the formulas.

        .data
blob_numbers:   .word 0.25, 0.16666666666666667, 4.0
        .code

; Adds the field of the piece about the interval's start.
        .macro  add_piece
        load_strength
        ray_times piece_a, interval_t, q0
        ray_scale piece_a, strength, q3         ; S a
        ray_plus piece_b, q0, q1                ; b'
        ray_plus piece_b, q1, q2
        ray_scale q1, strength4, q4             ; 4 S b'
        ray_times q2, interval_t, q2
        ray_times q3, piece_a, q5
        ray_plus q2, piece_c, q2                ; c'
        ray_times q4, piece_a, q6
        ray_times q4, q1, q7
        ray_scale q2, strength, q8              ; S c'
        ray_times q3, q2, q9
        add_to  k4, q5
        add_to  k3, q6
        add_to  k2, q7
        ray_plus q9, q9, q9
        ray_times q4, q2, q4
        ray_times q8, q2, q8
        add_to  k2, q9
        add_to  k1, q4
        add_to  k0, q8
        .endm

; Compares the signs of the Bernstein coefficients on the interval with that at
; its start.
        .macro  test_interval alike
        ray_minus interval_end, interval_t, interval_length
        begin_signs
        ray_times interval_length, interval_length, q4
        ray_times k1, interval_length, q0
        ray_times q4, interval_length, q5
        ray_times k2, q4, q1
        ray_times q4, q4, q6
        ray_times k3, q5, q2
        ray_scale q0, blob_quarter, q4
        ray_scale q1, blob_sixth, q5
        ray_times k4, q6, q3
        ray_scale q2, blob_quarter, q6
        ray_plus k0, q4, q7
        ray_plus q4, q5, q4
        signs_of q7, interval_signs_differ
        ray_plus q7, q4, q8
        ray_plus q4, q5, q4
        signs_of q8, interval_signs_differ
        ray_plus q4, q6, q4
        ray_plus k0, q0, q9
        ray_plus q8, q4, q8
        ray_plus q9, q1, q9
        signs_of q8, interval_signs_differ
        ray_plus q9, q2, q9
        ray_plus q9, q3, q9
        signs_of q9, interval_signs_differ
        end_signs interval_signs_differ, \alike
        .endm
