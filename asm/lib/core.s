; core.s - descriptors, constants and calls.
;
; A program may include this file several times; it is read once.

        .ifndef core.s
        .equ    core.s, 1

; r := descriptor of a vector with a length and a bit address. Both must be
; constants of the program. For values at run time use RTOR and ADDLEN.
        .macro  descriptor r, address, length
        EX      \r, \address
        ELEN    \r, \length
        .endm

; r := a word, as in load_constant r5, 1.5
        .macro  load_constant r, value
        EX      \r, bits(\value) & 0xFFFFFFFFFFFF
        ELEN    \r, bits(\value) >> 48 & 0xFFFF
        .endm

; h := a half word, as in load_half h40, 1.5, r9. The value is stored in the
; data; scratch is overwritten with its address.
        .macro  load_half h, value, scratch
        .data
load_half.\@:
        .halfword \value
        .code
        EX      \scratch, load_half.\@
        LODH    [\scratch], \h
        .endm

; number := the sum of the two parts of SUMV or DOTV, in an even register and
; the next one. The upper part is normalised first, to make room for the lower
; one, as in programs of the time (ACM Algorithm 663, P).
        .macro  join_parts upper, lower, number
        ADDN    \upper, r0, \upper
        ADDN    \upper, \lower, \number
        .endm

; Calls a routine. scratch is overwritten with its address, link with the
; address of the next instruction. The routine ends with: return link
        .macro  call routine, link, scratch
        EX      \scratch, \routine
        BSAVE   \link, [\scratch]
        .endm

        .macro  return link
        BIM     0, \link
        .endm

        .endif
