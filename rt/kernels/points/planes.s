; planes.s - the form of a program, and operations on planes of words in both
; forms.
;
; The form is scalar if the constant SCALAR is defined, otherwise vector. The
; scalar form is a loop over the words of planes; the vector form processes
; whole planes.
;
;       planes index, one, count, scratch, bits
;
; defines the operations of forms.s and these, for planes of count words. index,
; one = 1, count and the n below are registers with integers; scratch and bits
; are those of scalar_form and vector_form. a and b are registers with one word
; in the scalar form, and with the descriptor of a plane in the vector form.
;
;       each label              begins the loop over the words
;       next label, n           ends it; n is count by default, as below
;       plane address, a, n     a names the plane at the address
;       load address, a, n      the same, and a gets its words
;       fetch address, a        a gets the words of the plane that it names
;       store a, address        the plane that a names gets the words of a
;       fetch_into address, a, b        b gets the words of the plane of a
;       fill k, address, a      the plane of a gets the number k
;       set_word i, k, a        word i of a becomes k
;       conditions address, n   the control vector is at the address
;
; A column is one of a sequence of planes. In the scalar form its address is in
; the register at_a.
;
;       column address, a, n    a names the column at the address
;       advance a, step         a names the column that begins step bits later
;       skip a, words           a names the column without its first words
;
; A program that is written in two files, NAME_scalar.s and NAME_vector.s, is
; included by
;
;       by_hand NAME

        .ifndef planes.s
        .equ    planes.s, 1
        .include "forms.s"
        .include "frame/common.s"

        .ifdef  SCALAR
        .macro  planes index, one, count, scratch=, bits=
        scalar_form , \scratch
        .macro  each label
        ES      \index, 0
\label:
        .endm
        .macro  next label, n=\count
        IBXNE   \index, \one, \n, \label, \index
        .endm
        .macro  plane address, a, n=
        .endm
        .macro  load address, a, n=
        LOD     [\address, \index], \a
        .endm
        .macro  fetch address, a
        LOD     [\address, \index], \a
        .endm
        .macro  store a, address
        STO     [\address, \index], \a
        .endm
        .macro  fetch_into address, a, b
        LOD     [\address, \index], \b
        .endm
        .macro  fill k, address, a
        STO     [\address, \index], \k
        .endm
        .macro  set_word i, k, a
        IBXNE   \index, r0, \i, other\@
        RTOR    \k, \a
other\@:
        .endm
        .macro  conditions address, n=
        .endm
        .macro  column address, a, n=
        RTOR    \address, at_\a
        .endm
        .macro  advance a, step
        ADDX    at_\a, \step, at_\a
        .endm
        .macro  skip a, words
        IX      at_\a, 64 * (\words)
        .endm
        .endm
        .else
        .macro  planes index, one, count, scratch=, bits=
        vector_form , \bits
        .macro  each label
        .endm
        .macro  next label, n=
        .endm
        .macro  plane address, a, n=\count
        ADDLEN  \address, \n, \a
        .endm
        .macro  load address, a, n=\count
        ADDLEN  \address, \n, \a
        .endm
        .macro  fetch address, a
        .endm
        .macro  store a, address
        .endm
        .macro  fetch_into address, a, b
        VTOV    [\a], [\b]
        .endm
        .macro  fill k, address, a
        VTOV    \k, [\a]
        .endm
        .macro  set_word i, k, a
        STO     [\a, \i], \k
        .endm
        .macro  conditions address, n=\count
        describe \bits, \address, \n
        .endm
        .macro  column address, a, n=\count
        ADDLEN  \address, \n, \a
        .endm
        .macro  advance a, step
        ADDX    \a, \step, \a
        .endm
        .macro  skip a, words
        IX      \a, 64 * (\words)
        .endm
        .endm
        .endif

        .macro  by_hand program
        .ifdef  SCALAR
        .include "\program\()_scalar.s"
        .else
        .include "\program\()_vector.s"
        .endif
        .endm

        .endif
