; cylinder_in_frame_scalar.s - intersects one ray with a cylinder in the
; cylinder's own frame, its ends as planes.  The method is that of
; cylinder_in_frame_vector.s.
;
;       CALL CYLINDER (RAY, PRIMITIVE, SEGMENT)

        .share  local
        .regs   r58, fa, fb, fc, least, greatest
        .endshare
        shape_from r63
        .equ    IN_FRAME_REGISTERS, 45

        .data
in_frame_save:  .space IN_FRAME_REGISTERS
        .code

        .macro  candidate t
        CFPGE   \t, tin, not_first\@
        RTOR    \t, tin
not_first\@:
        CFPGE   tout, \t, not_last\@
        RTOR    \t, tout
not_last\@:
        .endm

; Divides the numerator t by a; a t between the ends is a candidate.
        .macro  on_side t
        DIVS    \t, fa, \t
        MPYS    \t, t6, t3
        ADDN    t3, t5, t3
        ABS     t3, t3
        CFPLT   sh13, t3, off_side\@
        candidate \t
off_side\@:
        .endm

        .macro  on_end at
        SUBN    \at, t5, t2
        DIVS    t2, t6, t2
        MPYS    t2, t0, t3
        MPYS    t2, t1, t4
        ADDN    t3, t7, t3
        ADDN    t4, t8, t4
        MPYS    t3, t3, t3
        MPYS    t4, t4, t4
        ADDN    t4, t3, t3
        CFPLT   sh12, t3, off_end\@
        candidate t2
off_end\@:
        .endm

        .kernel cylinder
cylinder:
        enter_kernel in_frame_save, IN_FRAME_REGISTERS, 14
        into_frame
        MPYS    t0, t0, fa
        MPYS    t1, t1, t2
        MPYS    t7, t0, fb
        MPYS    t8, t1, t3
        MPYS    t7, t7, fc
        MPYS    t8, t8, t4
        ADDN    t2, fa, fa
        ADDN    t3, fb, fb
        ADDN    t4, fc, fc
        MPYS    tiny, tiny, t2
        SUBN    fc, sh12, fc
        RTOR    big, tin
        RTOR    minus_big, tout
        CFPLT   fa, t2, in_frame_ends
        MPYS    fb, fb, t2
        MPYS    fa, fc, t3
        SUBN    t2, t3, t2
        CFPLT   t2, r0, in_frame_left
        SQRT    t2, t2
        SUBN    r0, fb, fb
        SUBN    fb, t2, least
        ADDN    fb, t2, greatest
        on_side least
        on_side greatest
in_frame_ends:
        ABS     t6, t3
        CFPLT   t3, tiny, in_frame_left
        SUBN    r0, sh13, t9
        on_end  t9
        on_end  sh13
in_frame_left:
        leave_kernel
        .endkernel
