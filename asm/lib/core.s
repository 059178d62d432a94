; core.s - descriptors, constants and calls.
;
; A program may include this file several times. It is read only once.

        .ifndef core.s
        .equ    core.s, 1

; r := the descriptor of a vector with a length and a bit address, which must
; be constants of the program. RTOR and ADDLEN handle values at run time.
        .macro  descriptor r, address, length
        EX      \r, \address
        ELEN    \r, \length
        .endm

; r := a word. Example: load_constant r5, 1.5
        .macro  load_constant r, value
        EX      \r, bits(\value) & 0xFFFFFFFFFFFF
        ELEN    \r, bits(\value) >> 48 & 0xFFFF
        .endm

; h := a half word, which is stored in the data. Its address overwrites
; scratch. Example: load_half h40, 1.5, r9
        .macro  load_half h, value, scratch
        .data
load_half.\@:
        .halfword \value
        .code
        EX      \scratch, load_half.\@
        LODH    [\scratch], \h
        .endm

; number := the sum of the two parts of SUMV or DOTV. They are in an even
; register and the next register. The upper part is normalised first, which
; makes room for the lower part (ACM Algorithm 663, a primary source).
        .macro  join_parts upper, lower, number
        ADDN    \upper, r0, \upper
        ADDN    \upper, \lower, \number
        .endm

; Calls a routine. Its address overwrites scratch, and the address of the next
; instruction overwrites link. The routine ends with: return link
        .macro  call routine, link, scratch
        EX      \scratch, \routine
        BSAVE   \link, [\scratch]
        .endm

        .macro  return link
        BIM     0, \link
        .endm

        .endif
