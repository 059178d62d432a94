; Bits and clocks are compared with those worked out by hand from the timing of
; docs/timing.md.
; MPYSV and CMPGEV run as one stream: the second makes bits, under a control vector
; and with an offset of its result.
        .equ    n, 6
        .regs   r10, va, product, bits, skipped, least, wanted
        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
        .bitvector z, n + 1, "1110111"
found:  .word   X'FFFF FFFF FFFF FFFF'
        .code
        EX      va, a                   ; at 0
        ELEN    va, n
        RTOR    va, product             ; only its length is used
        EX      bits, found
        ELEN    bits, n + 1
        ES      skipped, 1
        ES      least, 9
        EX      wanted, z
        LINKV                           ; at 8
        MPYSV   [va], [va], [product]
        CMPGEV  [product], least, [bits, skipped] ? [wanted]
        EXIT
; The squares are 1, 4, 9, 20.25, 0.25, 10,000 and the bits 1 to 6 of z are 110111.
; The first bit of the result is kept; then come 0 0 1 1 0 1, the third of which stays 1.
; expect: [found] = X'9BFF FFFF FFFF FFFF'
; expect-flags: X'0000 0000 0000 0000'
; Clocks: start-up 84, page 30 + 1,000, six elements on two pipes 3.
; expect-clocks: 8 + 84 + 1030 + 3
; expect-model: cyber205-2pipe-prior
