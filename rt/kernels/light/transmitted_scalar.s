; transmitted_scalar.s - computes the light that a surface between a point and a
; light transmits.  This macro is a part of the subroutines that trace shadow
; rays.

        .share  local
        .regs   r89, s_red, s_green, s_blue     ; the remaining light
        .regs   r92, s_clear, s_transmitted_r, s_transmitted_g, s_transmitted_b
        .endshare
        .equ    TRANSMITTED_REGISTERS, 7

        .data
transmitted_point: .space 3
transmitted_list: .descriptor 3, transmitted_point
transmitted_primitive: .word 0
                .descriptor 1, transmitted_cell
transmitted_cell: .space 1
        .code

; Multiplies the light by the colour that the primitive w_out transmits at the
; crossing w_in of the ray.  Branches to dark if it transmits none.
        .macro  pass_through dark
        load_of w_out, P_CLEAR, s_clear
        IBXEQ   s_clear, r0, r0, \dark
        three_by MPYS, w_in, w_dx, w_dy, w_dz, w_t0, w_t1, w_t2
        three   ADDN, w_ox, w_oy, w_oz, w_t0, w_t1, w_t2, w_t0, w_t1, w_t2
        store_words w_t0, 3, transmitted_point
        store_word w_out, transmitted_primitive
        call    pigment_cell, transmitted_list
        EX      w_at, transmitted_cell
        LOD     [w_at], w_t0
        ADDX    w_out, w_t0, w_at
        IX      w_at, 64 * P_TRANSMITTED
        load_from w_at, 3, s_transmitted_r
        MPYS    s_red, s_transmitted_r, s_red
        MPYS    s_green, s_transmitted_g, s_green
        MPYS    s_blue, s_transmitted_b, s_blue
        .endm
