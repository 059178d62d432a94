; functions.s - defines functions of numbers and of vectors by one formula.
;
; A formula is a macro with the arguments form, x, y, r, s. It consists of the
; operations of forms.s, written \form\()_times and so on; form is number or
; vector.
;
; Registers 208 to 255 belong to the library (docs/functions.md).

        .ifndef functions.s
        .equ    functions.s, 1

        .include "core.s"
        .include "forms.s"

        .regs   r208, f_link, f_target
        .regs   r210, f_x, f_y, f_r, f_s
        .regs   r214, f_0, f_1, f_2, f_3, f_4, f_5, f_6, f_7, f_8, f_9
        .regs   r224, f_scratch, f_bits
        .regs   r226, f_strip_x, f_strip_y, f_strip_r, f_strip_s, f_left, f_n
        .share  functions
        .reg    f_constants, r232       ; up to r255
        .endshare

; The vector form splits a vector into strips of this length.
        .ifndef F_STRIP
        .equ    F_STRIP, 2048
        .endif
        .if     F_STRIP < 1 || F_STRIP > 65535
        .error  "F_STRIP is the length of a vector: 1 to 65535"
        .endif
        .equ    F_WORK, 10              ; number of temporary vectors

        .data
f_work: .space  F_WORK * F_STRIP
        .bitvector f_work_bits, F_STRIP
        .code

        scalar_form number_, f_scratch, f_bits
        vector_form vector_, f_bits

; ---- Routines ----------------------------------------------------------------

; Defines the routines name and vname of a formula with the arguments form, x,
; y, r, s. A branch over them precedes them, so a program may contain them.
        .macro  routines name, formula
        BIM     \name\().over
        .kernel \name
\name: \formula number, f_x, f_y, f_r, f_s
        return  f_link
        .endkernel
        .kernel v\name
v\name:
        RTOR    f_x, f_strip_x
        RTOR    f_y, f_strip_y
        RTOR    f_r, f_strip_r
        RTOR    f_s, f_strip_s
        LTOR    f_r, f_left
        IBXEQ   f_left, r0, r0, v\name\().done
        EX      f_target, F_STRIP
v\name\().strip:
        RTOR    f_left, f_n
        IBXLE   f_left, r0, f_target, v\name\().fits
        RTOR    f_target, f_n
v\name\().fits:
        f_work_vector f_0, 0
        f_work_vector f_1, 1
        f_work_vector f_2, 2
        f_work_vector f_3, 3
        f_work_vector f_4, 4
        f_work_vector f_5, 5
        f_work_vector f_6, 6
        f_work_vector f_7, 7
        f_work_vector f_8, 8
        f_work_vector f_9, 9
        EX      f_bits, f_work_bits
        ADDLEN  f_bits, f_n, f_bits
        f_length f_strip_x
        f_length f_strip_y
        f_length f_strip_r
        f_length f_strip_s
        \formula vector, f_strip_x, f_strip_y, f_strip_r, f_strip_s
        IX      f_strip_x, 64 * F_STRIP
        IX      f_strip_y, 64 * F_STRIP
        IX      f_strip_r, 64 * F_STRIP
        IX      f_strip_s, 64 * F_STRIP
        EX      f_target, F_STRIP
        SUBX    f_left, f_n, f_left
        IBXGT   f_left, r0, r0, v\name\().strip
v\name\().done:
        return  f_link
        .endkernel
\name\().over:
        .endm

        .macro  f_work_vector vector, number
        EX      \vector, f_work + 64 * F_STRIP * \number
        ADDLEN  \vector, f_n, \vector
        .endm

        .macro  f_length vector
        ELEN    \vector, 0
        ADDLEN  \vector, f_n, \vector
        .endm

; Begins a formula: loads its constants, `count` words at name.constants.
        .macro  load_constants name, count
        EX      f_target, \name\().constants
        ELEN    f_target, \count
        SWAP    [f_target], f_constants, [r0]
        .endm

; r := routine(x), and r := routine(x, y), for numbers. The names of routines
; for vectors begin with v, and x, y, r are descriptors.
        .macro  apply routine, x, r
        RTOR    \x, f_x
        RTOR    \r, f_r
        call    \routine, f_link, f_target
        RTOR    f_r, \r
        .endm
        .macro  apply_two routine, x, y, r
        RTOR    \y, f_y
        apply   \routine, \x, \r
        .endm

        .endif
