; Limits and selections of both forms of forms.s are compared with words worked out by
; hand. A form that takes the other operand, or stores where the condition is false, makes
; a word differ.

        .include "core.s"
        .include "forms.s"
        .equ    n, 5
        .equ    indefinite, X'7000 0000 0000 0000'

        .regs   r10, i, step, end, at, x, y, z, low, high, mask, scratch

        scalar_form number_, scratch
        vector_form vector_, mask

        .data
xs:     .word   1.0, 2.0, -3.0, 7.0, indefinite
ys:     .word   2.0, 2.0, -4.0, 5.0, 6.0
        .bitvector bits, n
        .code
        ES      step, 1
        load_constant low, -3.5
        load_constant high, 3.0

; z = y, then the operation: element by element, and for all at once.
        .macro  both operation, count=n
        EX      end, \count
        .data
each.\operation: .space \count
all.\operation: .space \count
        .code
        ES      i, 0
next\@: EX      at, xs
        LOD     [at, i], x
        EX      at, ys
        LOD     [at, i], y
        RTOR    y, z
        \operation number
        EX      at, each.\operation
        STO     [at, i], z
        IBXNE   i, step, end, next\@, i
        descriptor x, xs, \count
        descriptor y, ys, \count
        descriptor z, all.\operation, \count
        descriptor mask, bits, \count
        VTOV    [y], [z]
        \operation vector
        .endm

        .macro  lowered form
        \form\()_not_above x, z
        .endm
        both    lowered, n - 1      ; without the indefinite one
; expect: [each.lowered] = 1.0, 2.0, -4.0, 5.0
; expect: [all.lowered] = 1.0, 2.0, -4.0, 5.0
        .macro  raised form
        \form\()_not_below x, z
        .endm
        both    raised, n - 1      ; without the indefinite one
; expect: [each.raised] = 2.0, 2.0, -3.0, 7.0
; expect: [all.raised] = 2.0, 2.0, -3.0, 7.0
        .macro  clamped form
        \form\()_not_above_number high, z
        \form\()_not_below_number low, z
        .endm
        both    clamped
; expect: [each.clamped] = 2.0, 2.0, -3.5, 3.0, 3.0
; expect: [all.clamped] = 2.0, 2.0, -3.5, 3.0, 3.0
        .macro  selected form
        \form\()_default x, z
        \form\()_if_above x, y, selected\@
        \form\()_then_set_or_copy high, x, z
        \form\()_end_if selected\@
        .endm
        both    selected
; expect: [each.selected] = 1.0, 2.0, 3.0, 3.0, indefinite
; expect: [all.selected] = 1.0, 2.0, 3.0, 3.0, indefinite
        .macro  replaced form
        \form\()_default low, z
        \form\()_if_beyond_number x, high, replaced\@
        \form\()_then_set_or high, low, z
        \form\()_end_if replaced\@
        .endm
        both    replaced
; expect: [each.replaced] = -3.5, -3.5, -3.5, 3.0, -3.5
; expect: [all.replaced] = -3.5, -3.5, -3.5, 3.0, -3.5
        EXIT
