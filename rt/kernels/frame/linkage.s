; linkage.s - the calling convention of the scalar program's subroutines.
;
; It is that of a FORTRAN compiler for this machine, as far as known (S):
; arguments stay in memory. The caller loads the address of a list of
; descriptors into arguments and branches by BSAVE. The subroutine saves the
; registers that it uses and loads its constants in one SWAP, loads the list and
; the data it refers to, stores its results, and swaps back. Such a call costs
; 200 to 300 clocks. LINPACK shows 260 to 295 (D; see docs/timing.md).
;
; For shapes with an object space (transform_scalar.s), the address of a second
; kernel is in inner.
;
; Registers: r7-r31 belong to the linkage and the main program. r32-r155 are
; local to each subroutine, which saves those that it declares (.share local).
; r200-r238 belong to power, r240-r252 to the main program, r253 and r254 are
; scratch.

        .include "frame/common.s"

; 1: there are shadow rays (light/shadow_scalar.s).
        option  CASTS_SHADOWS

        .regs   r7, link, arguments, save_at, image_at, target
        .reg    shape_at, image_at
        .share  main
        .reg    inner, r12
        .endshare
        .regs   r253, third, fourth               ; scratch, never saved

; The main program's constants, in the order of records.s, and some more. All
; subroutines may use them. A main program that calls none of these subroutines
; may use the registers for others.
        .share  main
        .regs   r18, m_one, m_half, m_two, m_big, m_minus_big, m_tiny, m_tmin
        .regs   r25, m_checker_shift
        .regs   r26, m_minus_one, m_index_one, m_index_minus_one, m_zero
        .endshare

; Local registers of the kernels: constants, arguments, the ray, its segment,
; temporaries. The words of the shape follow the temporaries that a kernel needs
; (shape_from). A kernel saves registers from its first constant on.
        .share  local
        .regs   r32, one, tiny, index_one, big, minus_big
        .regs   r37, a_ray, a_primitive, a_segment
        .reg    primitive, a_primitive
        .regs   r40, ox, oy, oz, dx, dy, dz
        .regs   r46, tin, tout
        .regs   r48, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9
        .endshare

        .macro  shape_from register
        .share  local
        .regs   \register, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10, sh11, sh12, sh13, sh14
        .endshare
        .endm
        shape_from r58                  ; after all temporaries

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
        call_routine \routine, link
        .endm

        .macro  load_main_constants
        load_words constants, CONSTANTS, m_one
        SUBN    r0, m_one, m_minus_one
        ES      m_index_one, 1
        ES      m_index_minus_one, -1
        ADDN    r0, r0, m_zero
        .endm

; Saves `number` local registers from `first` on, and loads the first
; `constants` of them from the image.
        .macro  enter image, constants, save, number, first=r32
        EX      image_at, \image
        ELEN    image_at, \constants
        EX      save_at, \save
        ELEN    save_at, \number
        SWAP    [image_at], \first, [save_at]
        .endm

        .macro  leave save, number
        load_words \save, \number, r32, save_at
        BIM     0, link
        .endm

; Enters a kernel that calls nothing: loads its constants from `first` on, its
; arguments, the ray, and `shape_words` words of the shape.
        .macro  enter_kernel save, registers, shape_words, first=one
        enter   image_\first, KERNEL_CONSTANTS - (image_\first - kernel_image) / 64, \save, \registers, \first
        load_from arguments, 3, a_ray
        SWAP    [a_ray], ox, [r0]
        IX      a_primitive, 64 * P_SHAPE
        load_from a_primitive, \shape_words, sh0
        .endm

        .macro  give_segment
        STO     [a_segment], tin
        STO     [a_segment, index_one], tout
        .endm

; Returns tin, tout. save_at is unchanged.
        .macro  leave_kernel first=one
        give_segment
        SWAP    [save_at], \first, [r0]
        BIM     0, link
        .endm
