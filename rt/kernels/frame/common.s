; common.s - sequences of instructions that many kernels share.
;
;       option name, value                   a constant, unless it is defined
;       load_word label, register            the word at the label
;       load_words label, number, first, at  words, to registers from first on
;       load_from at, number, first          the same, from the address in at
;       load_of record, offset, register     the word of a record
;       load_part record, offset, number, first, at
;       load_field field, register           the same of the record of primitive
;       load_record field, number, first
;       store_field field, register
;       load_shape number                    its shape, to registers from sh0 on
;       address_of record, offset, register  of a word of the record
;       store_word register, label, at
;       store_words first, number, label, at
;       store_to first, number, at
;       store_part first, number, record, offset, at
;       store_step register, at, step        the address advances by step bits
;       add_to_word label, count, at, work   count is a register
;       describe register, address, count    the descriptor of a vector
;       vector_bases vectors, store, bits, bit_store
;                                            descriptors of length 0: of vectors
;                                            of QUEUE words, then of QUEUE bits
;       lengthen_table bases, table, number, count, base_at, at, high
;                                            table = the number descriptors at
;                                            bases, with the length count
;       at_most most, left, count            the minimum of most and left
;       advance_by address, count, work      to the address after count words
;       if_none bits, count, label           to the label if no bit is one
;       keep_where test, a, b, bits, work    clears the bits for which the
;                                            comparison of a with b is false
;       call_routine routine, link           the routine returns by link
;       copy_three a, b, c, x, y, z, op      op a, x; op b, y; op c, z
;       three op, a, b, c, d, e, f, x, y, z  op a, d, x; op b, e, y; op c, f, z
;       three_by op, k, a, b, c, x, y, z     op k, a, x; op k, b, y; op k, c, z
;       no_code name                         the operation name, without code,
;                                            for one of two forms
;
; The including program names the registers primitive and shape_at, an address.
; record has the address of the record, and an offset is in words. at gets the
; address and the number; it is image_at by default. count of if_none gets the
; number of the bits that are one. op of copy_three is RTOR by default.

        .ifndef common.s
        .equ    common.s, 1

        .macro  option name, value=0
        .ifndef \name
        .equ    \name, \value
        .endif
        .endm

        .macro  load_word label, register
        EX      \register, \label
        LOD     [\register], \register
        .endm

        .macro  load_from at, number, first
        ELEN    \at, \number
        SWAP    [\at], \first, [r0]
        .endm

        .macro  load_words label, number, first, at=image_at
        EX      \at, \label
        load_from \at, \number, \first
        .endm

        .macro  address_of record, offset, register
        RTOR    \record, \register
        IX      \register, 64 * (\offset)
        .endm

        .macro  load_of record, offset, register
        address_of \record, \offset, \register
        LOD     [\register], \register
        .endm

        .macro  load_part record, offset, number, first, at=image_at
        address_of \record, \offset, \at
        load_from \at, \number, \first
        .endm

; Fields of the record of the current primitive.
        .macro  load_field field, register
        load_of primitive, \field, \register
        .endm

        .macro  load_record field, number, first
        load_part primitive, \field, \number, \first, shape_at
        .endm

        .macro  store_field field, register
        address_of primitive, \field, shape_at
        STO     [shape_at], \register
        .endm

        .macro  load_shape number
        load_record P_SHAPE, \number, sh0
        .endm

        .macro  store_word register, label, at=image_at
        EX      \at, \label
        STO     [\at], \register
        .endm

        .macro  store_to first, number, at
        ELEN    \at, \number
        SWAP    [r0], \first, [\at]
        .endm

        .macro  store_words first, number, label, at=image_at
        EX      \at, \label
        store_to \first, \number, \at
        .endm

        .macro  store_part first, number, record, offset, at=image_at
        address_of \record, \offset, \at
        store_to \first, \number, \at
        .endm

        .macro  store_step register, at, step
        STO     [\at], \register
        ADDX    \at, \step, \at
        .endm

        .macro  add_to_word label, count, at, work
        EX      \at, \label
        LOD     [\at], \work
        ADDX    \work, \count, \work
        STO     [\at], \work
        .endm

        .macro  describe register, address, count
        EX      \register, \address
        ADDLEN  \register, \count, \register
        .endm

        .macro  vector_bases vectors, store, bits=0, bit_store=0
        .rept   \vectors
        .descriptor 0, \store + 64 * QUEUE * \+
        .endr
        .rept   \bits
        .descriptor 0, \bit_store + 64 * ((QUEUE + 63) / 64) * \+
        .endr
        .endm

        .macro  lengthen_table bases, table, number, count, base_at, at, high
        SHIFTI  \count, 48, \high
        EX      \base_at, \bases
        ELEN    \base_at, \number
        EX      \at, \table
        ELEN    \at, \number
        ORV     [\base_at], \high, [\at]
        .endm

        .macro  at_most most, left, count
        EX      \count, \most
        IBXLE   \count, r0, \left, at_most\@
        RTOR    \left, \count
at_most\@:
        .endm

        .macro  advance_by address, count, work
        SHIFTI  \count, 6, \work
        ADDX    \address, \work, \address
        .endm

        .macro  if_none bits, count, label
        CNTOB   [\bits], \count
        IBXEQ   \count, r0, r0, \label
        .endm

        .macro  keep_where test, a, b, bits, work
        \test   \a, \b, [\work]
        ANDB    [\bits], [\work], [\bits]
        .endm

; The same operation on the three components of vectors or colours.
        .macro  three op, a, b, c, d, e, f, x, y, z
        \op     \a, \d, \x
        \op     \b, \e, \y
        \op     \c, \f, \z
        .endm

        .macro  three_by op, k, a, b, c, x, y, z
        \op     \k, \a, \x
        \op     \k, \b, \y
        \op     \k, \c, \z
        .endm

        .macro  copy_three a, b, c, x, y, z, op=RTOR
        \op     \a, \x
        \op     \b, \y
        \op     \c, \z
        .endm

        .macro  no_code name
        .macro  \name a=, b=, c=, d=
        .endm
        .endm

        .macro  call_routine routine, link
        EX      target, \routine
        BSAVE   \link, [target]
        .endm

        .endif
