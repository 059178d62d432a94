; print.s - requests to the monitor that print.
;
; None ends the line but newline.  They cost the clocks of an EXIT request.

        .ifndef print.s
        .equ    print.s, 1

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

; Numbers in columns: so wide, blanks before them, to the nearest of so many digits behind
; the point, or in all with the power of ten behind an e; integers; and vectors, so many
; elements a line (0: all in one).  scratch gets what the monitor is told.
        .macro  print_as kind, width, digits, in_line, scratch
        .if     (\width) < 0 || (\width) > 255 || (\digits) < 0 || (\digits) > 17
        .error  "a column is 0 to 255 wide and has 0 to 17 digits"
        .elseif (\in_line) < 0 || (\in_line) > 65535
        .error  "a line has 0 to 65535 elements"
        .endif
        EX      \scratch, (\kind) << 32 | (\in_line) << 16 | (\width) << 8 | (\digits)
        .endm
        .macro  print_fixed r, width, digits, scratch
        print_as 1, \width, \digits, 0, \scratch
        EXIT    \r, \scratch, 1
        .endm
        .macro  print_scientific r, width, digits, scratch
        print_as 2, \width, \digits, 0, \scratch
        EXIT    \r, \scratch, 1
        .endm
        .macro  print_integer_in r, width, scratch
        print_as 0, \width, 0, 0, \scratch
        EXIT    \r, \scratch, 2
        .endm
        .macro  print_vector_fixed d, width, digits, in_line, scratch
        print_as 1, \width, \digits, \in_line, \scratch
        EXIT    \d, \scratch, 6
        .endm
        .macro  print_vector_scientific d, width, digits, in_line, scratch
        print_as 2, \width, \digits, \in_line, \scratch
        EXIT    \d, \scratch, 6
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
