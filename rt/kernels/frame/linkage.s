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
; A kernel is called with the address of another one in inner, for shapes that
; stand in a space of their own (transform_scalar.s).
;
; Registers: r7-r31 belong to the linkage and the main program; r32-r155 are
; local to each subroutine, as many as it says (.share local): it saves what it
; finds there.  r200-r238 are those of power, r240-r252 the main program's, r253
; and r254 scratch.

        .regs   r7, link, arguments, save_at, image_at, target
        .share  main
        .reg    inner, r12
        .endshare
        .regs   r253, third, fourth               ; scratch, never saved

; The main program's constants, in the order of records.s, and some more; all
; subroutines may use them; a main program that calls none of these subroutines
; may have others there.
        .share  main
        .regs   r18, m_one, m_half, m_two, m_big, m_minus_big, m_tiny, m_tmin
        .regs   r25, m_checker_shift
        .regs   r26, m_minus_one, m_index_one, m_index_minus_one, m_zero
        .endshare

; The local registers of the kernels, all alike: constants, arguments, the ray,
; the segment found, work, the shape.
        .share  local
        .regs   r32, one, big, minus_big, tiny, index_one
        .regs   r37, a_ray, a_primitive, a_segment
        .regs   r40, ox, oy, oz, dx, dy, dz
        .regs   r46, tin, tout
        .regs   r48, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9
        .regs   r58, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10
        .regs   r69, sh11, sh12, sh13, sh14, sh15
        .endshare

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

; Load number registers from first on from the words at label.
        .macro  load_at label, number, first
        EX      image_at, \label
        ELEN    image_at, \number
        SWAP    [image_at], \first, [r0]
        .endm

        .macro  load_main_constants
        load_at constants, CONSTANTS, m_one
        SUBN    r0, m_one, m_minus_one
        ES      m_index_one, 1
        ES      m_index_minus_one, -1
        ADDN    r0, r0, m_zero
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

