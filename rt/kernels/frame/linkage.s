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

; 1: there are rays to lights (light/shadow_scalar.s).
        .ifndef CASTS_SHADOWS
        .equ    CASTS_SHADOWS, 0
        .endif

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

; The local registers of the kernels: constants, arguments, the ray, the segment
; found, work, and behind the work that a kernel needs the words of its shape
; (shape_from).  A kernel begins with the first constant that it needs.
        .share  local
        .regs   r32, one, tiny, index_one, big, minus_big
        .regs   r37, a_ray, a_primitive, a_segment
        .regs   r40, ox, oy, oz, dx, dy, dz
        .regs   r46, tin, tout
        .regs   r48, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9
        .endshare

        .macro  shape_from register
        .share  local
        .regs   \register, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10, sh11, sh12, sh13, sh14
        .endshare
        .endm
        shape_from r58                  ; behind all of the work

        .data
; The constants, as in records.s.
kernel_image:
image_one:      .word 1.0
image_tiny:     .word 1e-12
image_index_one: .word 1
image_big:      .word 1e30
image_minus_big: .word -1e30
        .equ    KERNEL_CONSTANTS, 5
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

; .. the word there.
        .macro  load_of label, register
        EX      \register, \label
        LOD     [\register], \register
        .endm

        .macro  load_main_constants
        load_at constants, CONSTANTS, m_one
        SUBN    r0, m_one, m_minus_one
        ES      m_index_one, 1
        ES      m_index_minus_one, -1
        ADDN    r0, r0, m_zero
        .endm

; Save number local registers from first on, load as many of them as there are
; constants in the image.
        .macro  enter image, constants, save, number, first=r32
        EX      image_at, \image
        ELEN    image_at, \constants
        EX      save_at, \save
        ELEN    save_at, \number
        SWAP    [image_at], \first, [save_at]
        .endm

        .macro  leave save, number
        EX      save_at, \save
        ELEN    save_at, \number
        SWAP    [save_at], r32, [r0]
        BIM     0, link
        .endm

; Enter a kernel that calls nothing: its constants from first on, its arguments,
; the ray, number words of the shape.
        .macro  enter_kernel save, registers, shape_words, first=one
        enter   image_\first, KERNEL_CONSTANTS - (image_\first - kernel_image) / 64, \save, \registers, \first
        ELEN    arguments, 3
        SWAP    [arguments], a_ray, [r0]
        SWAP    [a_ray], ox, [r0]
        IX      a_primitive, 64 * P_SHAPE
        ELEN    a_primitive, \shape_words
        SWAP    [a_primitive], sh0, [r0]
        .endm

        .macro  give_segment
        STO     [a_segment], tin
        STO     [a_segment, index_one], tout
        .endm

; Give back tin, tout.  save_at is as it was.
        .macro  leave_kernel first=one
        give_segment
        SWAP    [save_at], \first, [r0]
        BIM     0, link
        .endm
