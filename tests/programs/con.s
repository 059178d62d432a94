; CON: T := R contracted to 32 bits: the high 24 bits of its coefficient

        .include "contract.inc"

        contracts plain, CON, 1.5
; expect-halves: [plain] = 1.5
        contracts negative, CON, -200.25
; expect-halves: [negative] = -200.25

; floor
        contracts tenth, CON, 0.1
; expect-halves: [tenth] = X'E666 6666'
        contracts minus_tenth, CON, -0.1
; expect-halves: [minus_tenth] = X'E699 9999'
        contracts below, CON, X'FFD1 7FFF FFFF FFFF'
; expect-halves: [below] = X'E97F FFFF'

; it does not normalise: integers below 2^24 are lost
        contracts small, CON, 5
; expect-halves: [small] = X'1800 0000'
        contracts small_negative, CON, -5
; expect-halves: [small_negative] = X'18FF FFFF'
        contracts integer, CON, X'0000 7FFF FFFF FFFF'
; expect-halves: [integer] = X'187F FFFF'

; at the ends of the exponent range: 87 + 24 and -136 + 24
        contracts largest, CON, X'0057 4000 0000 0000'
; expect-halves: [largest] = X'6F40 0000'
        contracts overflow, CON, X'0058 4000 0000 0000'
; expect-halves: [overflow] = X'7000 0000'
        contracts smallest, CON, X'FF78 4000 0000 0000'
; expect-halves: [smallest] = X'9040 0000'
        contracts underflow, CON, X'FF77 7FFF FFFF FFFF'
; expect-halves: [underflow] = 0.0

; specials become the plain half words
        contracts zero, CON, X'8123 0000 0000 0005'
; expect-halves: [zero] = 0.0
        contracts indefinite, CON, X'7123 0000 0000 0005'
; expect-halves: [indefinite] = X'7000 0000'

; register 0 is machine zero; the other half stays
        EXH     h200, 7
        CON     r0, h201
; expect: r100 = X'0000 0007 8000 0000'
        CON     whole, h0
        CON     whole, h1
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
