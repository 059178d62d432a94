; memory.s - loads and stores words, and calls routines.
;
;       load_word label, register               the word at the label
;       load_words label, number, first, at     words, to registers from first on
;       load_from at, number, first             the same, from the address in at
;       load_of record, offset, register        the word of a record
;       load_part record, offset, number, first, at
;       store_word register, label, at
;       store_words first, number, label, at
;       store_to first, number, at
;       store_part first, number, record, offset, at
;       call_routine routine, link              the routine returns by link
;
; record has the address of the record, and an offset is in words. at gets the
; address and the number.

        .ifndef memory.s
        .equ    memory.s, 1

        .macro  load_word label, register
        EX      \register, \label
        LOD     [\register], \register
        .endm

        .macro  load_from at, number, first
        ELEN    \at, \number
        SWAP    [\at], \first, [r0]
        .endm

        .macro  load_words label, number, first, at
        EX      \at, \label
        load_from \at, \number, \first
        .endm

        .macro  load_of record, offset, register
        RTOR    \record, \register
        IX      \register, 64 * (\offset)
        LOD     [\register], \register
        .endm

        .macro  load_part record, offset, number, first, at
        RTOR    \record, \at
        IX      \at, 64 * (\offset)
        load_from \at, \number, \first
        .endm

        .macro  store_word register, label, at
        EX      \at, \label
        STO     [\at], \register
        .endm

        .macro  store_to first, number, at
        ELEN    \at, \number
        SWAP    [r0], \first, [\at]
        .endm

        .macro  store_words first, number, label, at
        EX      \at, \label
        store_to \first, \number, \at
        .endm

        .macro  store_part first, number, record, offset, at
        RTOR    \record, \at
        IX      \at, 64 * (\offset)
        store_to \first, \number, \at
        .endm

        .macro  call_routine routine, link
        EX      target, \routine
        BSAVE   \link, [target]
        .endm

        .endif
