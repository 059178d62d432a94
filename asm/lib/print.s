; print.s - requests to the monitor that print.
;
; None ends the line but newline.  They cost the clocks of an EXIT request.

        .ifndef newline

        .include "core.s"

; The number in register r in decimal, as an integer (its low 48 bits), or
; as the 16 hex digits of the word.
        .macro  print_number r
        EXIT    \r, r0, 1
        .endm
        .macro  print_integer r
        EXIT    \r, r0, 2
        .endm
        .macro  print_hex r
        EXIT    \r, r0, 3
        .endm

; The number in half register h, by way of a whole register.
        .macro  print_half h, scratch
        EXTH    \h, \scratch
        print_number \scratch
        .endm

; A text: print_text "clocks: ", r9.  Its bytes go among the data; scratch
; gets their descriptor.
        .macro  print_text text, scratch
        .data
print_text.\@:
        .text   \text
        .code
        descriptor \scratch, print_text.\@, length(\text)
        EXIT    \scratch, r0, 4
        .endm

        .macro  newline
        EXIT    r0, r0, 5
        .endm

; The numbers of the vector that descriptor d describes, blanks between them;
; the bits of a bit vector.
        .macro  print_vector d
        EXIT    \d, r0, 6
        .endm
        .macro  print_bits d
        EXIT    \d, r0, 7
        .endm

; The half words that descriptor d describes, extended first to the vector of
; words that descriptor whole describes, which is as long.
        .macro  print_half_vector d, whole
        EXTV    [\d], [\whole]
        print_vector \whole
        .endm

        .endif
