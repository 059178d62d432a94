; The output of the monitor for each request is compared with the expected lines, for
; words, vectors, bits and text in memory.  A wrong format or request fails.
; tests: EXIT
; EXIT: request I8 to the monitor with the operands R and S; request 0 ends the
; program

        .regs   r10, number, text, vector, bits

        .data
letters:
        .word   X'4849 0000 0000 0000'  ; two bytes of text
values: .word   1.5, -2.0, 3
        .bitvector ones, 5, "10110"
        .code
        EX      number, values
        LOD     [number], number
        EXIT    number, r0, 1           ; a number in decimal
        EXIT    r0, r0, 5
; expect-print: 1.5
        ES      number, -7
        EXIT    number, r0, 2           ; an integer
        EXIT    r0, r0, 5
; expect-print: -7
        EXIT    number, r0, 3           ; a word in hexadecimal
        EXIT    r0, r0, 5
; expect-print: 0000 FFFF FFFF FFF9
        EX      text, letters
        ELEN    text, 2
        EXIT    text, r0, 4             ; text, length in bytes
        EXIT    r0, r0, 5
; expect-print: HI
        EX      vector, values
        ELEN    vector, 3
        EXIT    vector, r0, 6           ; a vector of numbers
        EXIT    r0, r0, 5
; expect-print: 1.5 -2 3
        EX      bits, ones
        ELEN    bits, 5
        EXIT    bits, r0, 7             ; a bit vector
        EXIT    r0, r0, 5
; expect-print: 10110
        EXIT                            ; the end
        ES      number, 0
        EXIT
; expect: r10 = X'0000 FFFF FFFF FFF9'
