; normalise.s - a kernel that is written once and runs in two forms.
;
; It normalises n vectors (x, y). A vector of length 0 becomes (1, 0). A loop
; runs the kernel on numbers. The second part of the program runs it once on
; whole vectors (asm/lib/forms.s, docs/forms.md).

        .include "print.s"
        .include "forms.s"
        .equ    n, 1000

        .regs   r10, one, i, step_i, end_i, xs, ys, us, vs, equal, bits, spare
        .regs   r21, x, y, a, b, scratch, mask, value

        scalar_form number_, scratch
        vector_form vector_, mask

; (x, y) = (x, y) / |(x, y)|
        .macro  direction form
        \form\()_times x, x, a
        \form\()_times y, y, b
        \form\()_plus a, b, a
        \form\()_if_equal_number a, r0, some\@
        \form\()_then_set one, a
        \form\()_then_set one, x
        \form\()_end_if some\@
        \form\()_root a, a
        \form\()_into one, a, a
        \form\()_times x, a, x
        \form\()_times y, a, y
        .endm

        .data
        .vector first_x, n
        .vector first_y, n
        .vector loop_x, n
        .vector loop_y, n
        .vector work_a, n
        .vector work_b, n
        .bitvector work_mask, n
        .bitvector same, n
        .code

        .kernel values
        load_constant one, 1.0
        ES      i, 0
        ES      step_i, 1
        EX      end_i, n
        EX      xs, first_x
        EX      ys, first_y
        EX      us, loop_x
        EX      vs, loop_y
        ADDN    r0, r0, x
        ADDN    r0, r0, y
next_value:
        STO     [xs, i], x
        STO     [ys, i], y
        ADDN    x, one, x
        SUBN    x, y, y
        IBXNE   i, step_i, end_i, next_value, i
        .endkernel

        .kernel loop
        ES      i, 0
next:   LOD     [xs, i], x
        LOD     [ys, i], y
        direction number
        STO     [us, i], x
        STO     [vs, i], y
        IBXNE   i, step_i, end_i, next, i
        .endkernel

        .kernel vectors
        descriptor x, first_x, n
        descriptor y, first_y, n
        descriptor a, work_a, n
        descriptor b, work_b, n
        descriptor mask, work_mask, n
        direction vector
        .endkernel

        descriptor us, loop_x, n
        descriptor vs, loop_y, n
        descriptor equal, same, n
        CMPEQV  [us], [x], [equal]
        CNTOB   [equal], value
        print_text "equal x: ", spare
        print_integer value
        newline
        CMPEQV  [vs], [y], [equal]
        CNTOB   [equal], value
        print_text "equal y: ", spare
        print_integer value
        newline
        EXIT
; expect-print: equal x: 1000
; expect-print: equal y: 1000
