; Words contracted to half words, and half words extended, are compared with results
; worked out by hand: both signs, ties, the ends of the exponent range, specials.  A
; wrong rounding, exponent, half or data flag makes a word differ.
; tests: CON RCON EXTH

        .include "scalar.inc"

        .macro  contracts op, name, r, want
        fetch   left, \r
        \op     left, half_result
        keep_half \op\().\name
; expect-halves: [\op\().\name] = \want
        .endm

; Register 0 is machine zero.  The other half of the result is kept.
        .macro  register_0 op
        EXH     h200, 7
        \op     r0, h201
        register_is \op, r100, X'0000 0007 8000 0000'
        \op     left, h0
        \op     left, h1
; expect: r0 = 0
        flags_are \op, X'0000 0000 0032 0000'
        .endm

; CON: T := R contracted to 32 bits: the high 24 bits of its coefficient
        contracts CON, plain, 1.5, 1.5
        contracts CON, negative, -200.25, -200.25
; floor
        contracts CON, tenth, 0.1, X'E666 6666'
        contracts CON, minus_tenth, -0.1, X'E699 9999'
        contracts CON, below, X'FFD1 7FFF FFFF FFFF', X'E97F FFFF'
; CON does not normalise: integers below 2^24 are lost
        contracts CON, small, 5, X'1800 0000'
        contracts CON, small_negative, -5, X'18FF FFFF'
        contracts CON, integer, X'0000 7FFF FFFF FFFF', X'187F FFFF'
; at the ends of the exponent range: 87 + 24 and -136 + 24
        contracts CON, largest, X'0057 4000 0000 0000', X'6F40 0000'
        contracts CON, overflow, X'0058 4000 0000 0000', X'7000 0000'
        contracts CON, smallest, X'FF78 4000 0000 0000', X'9040 0000'
        contracts CON, underflow, X'FF77 7FFF FFFF FFFF', 0.0
; specials become the plain half words
        contracts CON, zero, X'8123 0000 0000 0005', 0.0
        contracts CON, indefinite, X'7123 0000 0000 0005', X'7000 0000'
        register_0 CON
; RCON: T := R contracted to 32 bits, coefficient rounded to nearest, ties
; upwards
        contracts RCON, plain, 1.5, 1.5
; rounded down and up
        contracts RCON, tenth, 0.1, X'E666 6666'
        contracts RCON, three_tenths, 0.3, X'E84C CCCD'
        contracts RCON, minus_tenth, -0.1, X'E699 999A'
        contracts RCON, minus_three_tenths, -0.3, X'E8B3 3333'
; ties
        contracts RCON, half, X'0000 0000 0080 0000', X'1800 0001'
        contracts RCON, less, X'0000 0000 007F FFFF', X'1800 0000'
        contracts RCON, minus_half, X'0000 FFFF FF80 0000', X'1800 0000'
; 2^23 does not fit: the coefficient is 2^22 and the exponent is increased by 1
        contracts RCON, carry, X'FFD1 7FFF FFFF FFFF', 1.0
; at the ends of the exponent range: 87 + 24 and -136 + 24
        contracts RCON, largest, X'0057 7FFF FF7F FFFF', X'6F7F FFFF'
        contracts RCON, overflow, X'0057 7FFF FFFF FFFF', X'7000 0000'
        contracts RCON, smallest, X'FF77 7FFF FFFF FFFF', X'9040 0000'
        contracts RCON, underflow, X'FF77 4000 0000 0000', 0.0
; specials become the plain half words
        contracts RCON, zero, X'8123 0000 00FF FFFF', 0.0
        contracts RCON, indefinite, X'7123 0000 00FF FFFF', X'7000 0000'
        register_0 RCON

; EXTH: T := R extended to 64 bits
        .macro  extends name, r, want
        fetch_half half_left, \r
        EXTH    half_left, result
        keep    EXTH.\name
; expect: [EXTH.\name] = \want
        .endm
        extends plain, 1.5, 1.5
        extends negative, -200.25, -200.25
        extends tenth, 0.1, X'FFCE 6666 6600 0000'
; the result is exact and not normalised
        extends integer, 5, X'FFE8 0000 0500 0000'
        extends minus_one, -1, X'FFE8 FFFF FF00 0000'
        extends zero_coefficient, X'1000 0000', X'FFF8 0000 0000 0000'
        extends largest, X'6F7F FFFF', X'0057 7FFF FF00 0000'
        extends smallest, X'9040 0000', X'FF78 4000 0000 0000'
; specials become the plain words
        extends zero, X'8012 3456', 0.0
        extends indefinite, X'7012 3456', indefinite
; h0 and h1 are machine zero
        EXTH    h0, r41
        EXTH    h1, r42
        EXTH    half_left, r0
        register_is EXTH, r41, 0.0
        register_is EXTH, r42, 0.0
; expect: r0 = 0
        flags_are EXTH, X'0000 0000 0012 0000'
        EXIT
