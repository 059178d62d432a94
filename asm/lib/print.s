; print.s - macros that request output from the monitor.
;
; Only newline ends a line. Each macro takes the clocks of an EXIT request.

        .ifndef print.s
        .equ    print.s, 1

        .include "core.s"

; Print register r as a decimal number, as the integer in the low 48 bits, or
; as a word of 16 hex digits.
        .macro  print_number r
        EXIT    \r, r0, 1
        .endm
        .macro  print_integer r
        EXIT    \r, r0, 2
        .endm
        .macro  print_hex r
        EXIT    \r, r0, 3
        .endm

; Print numbers in columns of a width: fixed with the given digits after the
; point, scientific with an exponent, or as integers. A vector has in_line
; elements per line (0: all). The format overwrites scratch.
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

; Prints the number in half register h. The word for it overwrites scratch.
        .macro  print_half h, scratch
        EXTH    \h, \scratch
        print_number \scratch
        .endm

; Prints a text, which is stored in the data. Its descriptor overwrites
; scratch. Example: print_text "clocks: ", r9
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

; Print the vector of descriptor d: its numbers separated by blanks, or the
; bits of a bit vector.
        .macro  print_vector d
        EXIT    \d, r0, 6
        .endm
        .macro  print_bits d
        EXIT    \d, r0, 7
        .endm

; Prints the half words of descriptor d. They are first extended to words in
; the vector of descriptor whole, which must have the same length.
        .macro  print_half_vector d, whole
        EXTV    [\d], [\whole]
        print_vector \whole
        .endm

        .endif
