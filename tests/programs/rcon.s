; RCON: T := R contracted to 32 bits, its coefficient rounded, a half upwards

        .include "contract.inc"

        contracts plain, RCON, 1.5
; expect-halves: [plain] = 1.5

; down and up
        contracts tenth, RCON, 0.1
; expect-halves: [tenth] = X'E666 6666'
        contracts three_tenths, RCON, 0.3
; expect-halves: [three_tenths] = X'E84C CCCD'
        contracts minus_tenth, RCON, -0.1
; expect-halves: [minus_tenth] = X'E699 999A'
        contracts minus_three_tenths, RCON, -0.3
; expect-halves: [minus_three_tenths] = X'E8B3 3333'

; a half
        contracts half, RCON, X'0000 0000 0080 0000'
; expect-halves: [half] = X'1800 0001'
        contracts less, RCON, X'0000 0000 007F FFFF'
; expect-halves: [less] = X'1800 0000'
        contracts minus_half, RCON, X'0000 FFFF FF80 0000'
; expect-halves: [minus_half] = X'1800 0000'

; 2^23 does not fit: 2^22, exponent one more
        contracts carry, RCON, X'FFD1 7FFF FFFF FFFF'
; expect-halves: [carry] = 1.0

; at the ends of the exponent range: 87 + 24 and -136 + 24
        contracts largest, RCON, X'0057 7FFF FF7F FFFF'
; expect-halves: [largest] = X'6F7F FFFF'
        contracts overflow, RCON, X'0057 7FFF FFFF FFFF'
; expect-halves: [overflow] = X'7000 0000'
        contracts smallest, RCON, X'FF77 7FFF FFFF FFFF'
; expect-halves: [smallest] = X'9040 0000'
        contracts underflow, RCON, X'FF77 4000 0000 0000'
; expect-halves: [underflow] = 0.0

; specials become the plain half words
        contracts zero, RCON, X'8123 0000 00FF FFFF'
; expect-halves: [zero] = 0.0
        contracts indefinite, RCON, X'7123 0000 00FF FFFF'
; expect-halves: [indefinite] = X'7000 0000'

; register 0 is machine zero; the other half stays
        EXH     h200, 7
        RCON    r0, h201
; expect: r100 = X'0000 0007 8000 0000'
        RCON    whole, h0
        RCON    whole, h1
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
