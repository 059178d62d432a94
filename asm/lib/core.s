; core.s - descriptors, constants and calls.
;
; Include it as often as needed; it is read once.

        .ifndef core.s
        .equ    core.s, 1

; r := descriptor of a vector of length elements at a bit address.  Both are
; constants of the program; at run time: RTOR and ADDLEN.
        .macro  descriptor r, address, length
        EX      \r, \address
        ELEN    \r, \length
        .endm

; r := any word: load_constant r5, 1.5
        .macro  load_constant r, value
        EX      \r, bits(\value) & 0xFFFFFFFFFFFF
        ELEN    \r, bits(\value) >> 48 & 0xFFFF
        .endm

; h := any half word: load_half h40, 1.5, r9.  It goes among the data; scratch
; gets its address.
        .macro  load_half h, value, scratch
        .data
load_half.\@:
        .halfword \value
        .code
        EX      \scratch, load_half.\@
        LODH    [\scratch], \h
        .endm

; number := the sum of two parts that SUMV and DOTV leave in an even register
; and the one after it, as programs of the time had it (ACM Algorithm 663, P):
; the upper part is normalised first, so that it has room for the lower.
        .macro  join_parts upper, lower, number
        ADDN    \upper, r0, \upper
        ADDN    \upper, \lower, \number
        .endm

; Call a routine: its address goes to scratch, that of the next instruction
; to link.  The routine ends with: return link
        .macro  call routine, link, scratch
        EX      \scratch, \routine
        BSAVE   \link, [\scratch]
        .endm

        .macro  return link
        BIM     0, \link
        .endm

        .endif
