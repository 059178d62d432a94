; vectors.s - short vectors for examples and tests.

        .ifndef vectors.s
        .equ    vectors.s, 1

        .include "core.s"

; Stores four words at a.words and their descriptor in register a.
        .macro  words a, first=0, second=0, third=0, fourth=0
        .data
\a\().words:
        .word   \first, \second, \third, \fourth
        .code
        descriptor \a, \a\().words, 4
        .endm

; Stores four half words at a.halves and their descriptor in register a.
        .macro  halves a, first=0, second=0, third=0, fourth=0
        .data
\a\().halves:
        .halfword \first, \second, \third, \fourth
        .code
        descriptor \a, \a\().halves, 4
        .endm

; Stores bits such as "1011" at z.bits and their descriptor in register z.
        .macro  bits z, text
        .data
        .bitvector \z\().bits, length(\text), \text
        .code
        descriptor \z, \z\().bits, length(\text)
        .endm

        .endif
