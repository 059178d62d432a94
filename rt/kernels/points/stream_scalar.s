; stream_scalar.s - the random stream: five numbers for every ray, which depend on
; the seed, the ray's number and nothing else; one ray at a time.
;
; Draw d = 0 .. 4 of ray r of the seed s is the number at the position p of one
; sequence:
;
;   p = s G + 5 r + d + 1                   G = 2^45 / golden ratio, odd
;   x = a^p mod 2^47                        a = 44485709377909
;   t = x xor (x >> 23)
;   t = t c mod 2^47                        c = 5851F42D4C95 (hex)
;   t = t xor (t >> 24)
;   u = t 2^-47
;
; x is odd, and the steps from x to t can be undone, so no t is 0 and u lies in
; (0, 1).  a = 5 mod 8, so positions count modulo 2^45.  Rays are an odd number of
; draws apart: with a power of two between them the low bits of their x would be
; alike.  Of N seeds in a row the nearest two begin at least 2^45 / (2.7 N) draws
; apart, as multiples of the golden ratio lie (three distances).
;
; Scalar operations come in stages, all draws of one after those of the other, so
; that none waits for a result.
;
; Sources: a is that of RANF on CYBER 170s and Crays, modulo 2^48 there (Knuth, TAOCP
; 2, 3.3.4); the output mixed by shifts and a product as in O'Neill, "PCG" (2014);
; skips by binary powers, Brown, "Random number generation with arbitrary strides"
; (1994).  c is the upper 48 bits of MMIX's multiplier 6364136223846793005 (Knuth); G is
; derived here.

        .ifndef stream_registers

        .equ    STREAM_MULTIPLIER, 44485709377909
        .equ    STREAM_MIX, X'5851 F42D 4C95'
        .equ    STREAM_TO_UNIT, 7.105427357601002e-15
        .equ    STREAM_SEED_APART, 21745137823721
        .equ    STREAM_DRAWS, 5

        .data
stream_constants:
        .word   STREAM_MIX, STREAM_TO_UNIT, 1, STREAM_MULTIPLIER
        .equ    STREAM_CONSTANTS, 4
        .code

; The registers of the stream, from first on: c, 2^-47, 1, a .. a^5.
        .macro  stream_registers first
        .regs   \first, stream_mix, stream_to_unit, stream_one, stream_ahead0, stream_ahead1, stream_ahead2, stream_ahead3, stream_ahead4
        .endm

        .macro  stream_load scratch
        EX      \scratch, stream_constants
        ELEN    \scratch, STREAM_CONSTANTS
        SWAP    [\scratch], stream_mix, [r0]
        MPYL    stream_ahead0, stream_ahead0, stream_ahead1
        MPYL    stream_ahead1, stream_ahead0, stream_ahead2
        MPYL    stream_ahead1, stream_ahead1, stream_ahead3
        MPYL    stream_ahead2, stream_ahead1, stream_ahead4
        .endm

; power := a^exponent mod 2^47, exponent an integer in [0, 2^47), which ends as 0.
        .macro  stream_power exponent, power, square, bit
        ES      \power, 1
        RTOR    stream_ahead0, \square
        BIM     enough\@
raise\@:
        AND     \exponent, stream_one, \bit
        IBXEQ   \bit, r0, r0, even\@
        MPYL    \power, \square, \power
even\@:
        MPYL    \square, \square, \square
        SHIFTI  \exponent, -1, \exponent
enough\@:
        IBXNE   \exponent, r0, r0, raise\@
        .endm

; state := x of the position s G + number draws: of ray `number` under the seed s where
; each takes 5 draws.  seed, in [0, 2^45), and number are registers with integers,
; draws an integer; number and draws may be negative.  position, square and bit are
; scratch.
        .macro  stream_state seed, number, draws, state, position, square, bit
        EX      \position, STREAM_SEED_APART
        MPYL    \position, \seed, \position
        ES      \square, \draws
        MPYL    \square, \number, \square
        ADDX    \position, \square, \position
        MPYL    \position, stream_one, \position        ; mod 2^47
        stream_power \position, \state, \square, \bit
        .endm

; [word] := t of x, and u := word 2^-47, of so many at a time: names that end in \+
; stand for as many registers, x\+ for x0, x1 .. work is scratch.
        .macro  stream_mixed count, x, word, work, mix=stream_mix
        .rept   \count
        SHIFTI  \x, -23, \work
        .endr
        .rept   \count
        XOR     \x, \work, \word
        .endr
        .rept   \count
        MPYL    \word, \mix, \word
        .endr
        .rept   \count
        SHIFTI  \word, -24, \work
        .endr
        .rept   \count
        XOR     \word, \work, \word
        .endr
        .endm

        .macro  stream_units count, word, u, to_unit=stream_to_unit
        .rept   \count
        ADDN    \word, r0, \u
        .endr
        .rept   \count
        MPYS    \u, \to_unit, \u
        .endr
        .endm

; word\+ := the t of the ray's five draws; state, that of the ray, becomes that of
; the next one.  work\+ is scratch.
        .macro  stream_words state, word, work
        .rept   STREAM_DRAWS
        MPYL    \state, stream_ahead\+, \word
        .endr
        MPYL    \state, stream_ahead4, \state
        stream_mixed STREAM_DRAWS, \word, \word, \work
        .endm

        .endif

