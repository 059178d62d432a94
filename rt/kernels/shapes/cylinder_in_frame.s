; cylinder_in_frame.s - intersects rays with a cylinder in the cylinder's own
; frame, its ends as planes.
;
; This is one of the formulations that were tried for Table 1 (docs/table1.md).
; Frame and record are those of cylinder_vector.s.  Across the axis:
;
;   a = du^2 + dv^2,  b = ou du + ov dv,  c = ou^2 + ov^2 - r^2
;   t = (-b - sqrt(b^2 - a c)) / a,  (-b + sqrt(b^2 - a c)) / a
;                                  valid if |ow + t dw| <= half
;   t = (-half - ow) / dw,  (half - ow) / dw
;                                  valid if (ou + t du)^2 + (ov + t dv)^2 <= r^2
;
; tin is the smallest valid t, tout the largest.  If a < tiny^2 the sides are
; skipped; if |dw| < tiny the ends are.
;
;       CALL CYLINDER (RAY, PRIMITIVE, SEGMENT)
;
; In:  ox oy oz dx dy dz; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Source: textbook.

; Divides the numerator t by a; a t between the ends is a candidate.
        .macro  on_side t
        quotient_by \t, quad_a, shift, \t
        ray_times \t, t6, t3
        ray_plus t3, t5, t3
        candidate_within t3, sh13, \t
        .endm

        .macro  on_end at
        ray_from \at, t5, t2
        quotient_by t2, t6, shift, t2
        ray_times t2, t0, t3
        ray_times t2, t1, quad_c
        ray_plus t3, t7, t3
        ray_plus quad_c, t8, quad_c
        ray_times t3, t3, t3
        ray_times quad_c, quad_c, quad_c
        ray_plus quad_c, t3, t3
        candidate_not_above t3, sh12, t2
        .endm

        shape_record in_frame, 14, 62           ; after quad_c
        .kernel cylinder
cylinder:
        enter_shape in_frame
        into_frame
        ray_times t0, t0, quad_a
        ray_times t1, t1, t2
        ray_times t7, t0, quad_b
        ray_times t8, t1, t3
        ray_times t7, t7, quad_c
        ray_times t8, t8, shift
        ray_plus t2, quad_a, quad_a             ; a
        ray_plus t3, quad_b, quad_b             ; b
        ray_plus shift, quad_c, quad_c
        MPYS    tiny, tiny, number
        ray_lower quad_c, sh12, quad_c          ; c
        ray_set big, tin
        ray_set minus_big, tout
        sides_unless_along quad_a, number, shift, in_frame_along
        ray_times quad_b, quad_b, t2
        ray_times quad_a, quad_c, t3
        ray_minus t2, t3, t2
        real_root t2, in_frame_across
        opposite_roots quad_b, t2, quad_c, t2
        on_side quad_c
        on_side t2
        ends_unless_across quad_a, number, t6, shift, in_frame_along, in_frame_across
        SUBN    r0, sh13, number
        on_end  number
        on_end  sh13
in_frame_across:
        leave_shape
        .endkernel
