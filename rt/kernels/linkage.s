; linkage.s - how the scalar program's subroutines are called.
;
; The way of a FORTRAN compiler for this machine, as far as it is known (S):
; arguments stay in memory.  The caller puts the address of a list of
; descriptors into arguments and branches by BSAVE; the subroutine saves the
; registers it is going to use and loads its constants in one SWAP, loads the
; list, then what it points at, stores its results, and swaps back.  A call
; costs 200 to 300 clocks so, of which LINPACK shows 260 to 295 (D; see
; docs/timing.md).
;
; Registers: r7-r31 belong to the linkage and the main program; r32-r155 are
; local to each subroutine, as many as it says; r200-r238 are those of power,
; r240-r252 the main program's, r253 and r254 scratch.

        .regs   r7, link, arguments, save_at, image_at, target
        .regs   r253, third, fourth               ; scratch, never saved

; The local registers of the kernels, all alike: constants, arguments, the ray,
; the segment found, work, the shape.
        .regs   r32, one, big, minus_big, tiny, index_one
        .regs   r37, a_ray, a_primitive, a_segment
        .regs   r40, ox, oy, oz, dx, dy, dz
        .regs   r46, tin, tout
        .regs   r48, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9
        .regs   r58, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10
        .regs   r69, sh11, sh12, sh13, sh14, sh15

        .data
; What the local registers hold when a kernel begins: the constants, as in
; records.s, and nothing in the others.
        .equ    KERNEL_REGISTERS_MOST, 57
kernel_image:
        .word 1.0, 1e30, -1e30, 1e-12, 1
        .space KERNEL_REGISTERS_MOST - 5
        .code

        .macro  call routine, list
        EX      arguments, \list
        EX      target, \routine
        BSAVE   link, [target]
        .endm

; Save the first number local registers at save, load them from image.
        .macro  enter image, save, number
        EX      image_at, \image
        ELEN    image_at, \number
        EX      save_at, \save
        ELEN    save_at, \number
        SWAP    [image_at], r32, [save_at]
        .endm

        .macro  leave save, number
        EX      save_at, \save
        ELEN    save_at, \number
        SWAP    [save_at], r32, [r0]
        BIM     0, link
        .endm

; Enter a kernel: its arguments, the ray, number words of the shape.
        .macro  enter_kernel save, registers, shape_words
        enter   kernel_image, \save, \registers
        ELEN    arguments, 3
        SWAP    [arguments], a_ray, [r0]
        SWAP    [a_ray], ox, [r0]
        IX      a_primitive, 64 * P_SHAPE
        ELEN    a_primitive, \shape_words
        SWAP    [a_primitive], sh0, [r0]
        .endm

; Give back tin, tout.
        .macro  leave_kernel save, registers
        STO     [a_segment], tin
        STO     [a_segment, index_one], tout
        leave   \save, \registers
        .endm

; sum = x . u, in the order (x1 u1 + x0 u0) + x2 u2.  Results take five clocks,
; so independent products stand before the sums that wait for them.
        .macro  dot x0, x1, x2, u0, u1, u2, sum, work
        MPYS    \x0, \u0, \sum
        MPYS    \x1, \u1, \work
        MPYS    \x2, \u2, third
        ADDN    \work, \sum, \sum
        ADDN    third, \sum, \sum
        .endm

; Three such sums at a time, a, b, c of x with the rows a, b, c: nothing waits.
        .macro  dot_rows x0, x1, x2, a0, a1, a2, b0, b1, b2, c0, c1, c2, a, b, c, w0, w1, w2, w3
        MPYS    \x0, \a0, \a
        MPYS    \x0, \b0, \b
        MPYS    \x0, \c0, \c
        MPYS    \x1, \a1, \w0
        MPYS    \x1, \b1, \w1
        MPYS    \x1, \c1, \w2
        MPYS    \x2, \a2, \w3
        MPYS    \x2, \b2, third
        MPYS    \x2, \c2, fourth
        ADDN    \w0, \a, \a
        ADDN    \w1, \b, \b
        ADDN    \w2, \c, \c
        ADDN    \w3, \a, \a
        ADDN    third, \b, \b
        ADDN    fourth, \c, \c
        .endm

        .macro  normalise_by unit, x0, x1, x2, length, work
        dot     \x0, \x1, \x2, \x0, \x1, \x2, \length, \work
        SQRT    \length, \length
        DIVS    \unit, \length, \work
        MPYS    \x0, \work, \x0
        MPYS    \x1, \work, \x1
        MPYS    \x2, \work, \x2
        .endm

        .macro  normalise x0, x1, x2, length, work
        normalise_by one, \x0, \x1, \x2, \length, \work
        .endm
