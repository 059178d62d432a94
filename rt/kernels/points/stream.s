; stream.s - the random stream: five numbers for each ray, in both forms.
;
; The numbers depend only on the seed and the number of the ray. Draw d = 0 .. 4
; of ray r of the seed s is the number at position p of one sequence:
;
;   p = s G + 5 r + d + 1                   G = 2^45 / golden ratio, odd
;   x = a^p mod 2^47                        a = 44485709377909
;   t = x xor (x >> 23)
;   t = t c mod 2^47                        c = 5851F42D4C95 (hex)
;   t = t xor (t >> 24)
;   u = t 2^-47
;
; x is odd and the steps from x to t are invertible, so t is never 0 and u is in
; (0, 1). a = 5 mod 8, so positions are modulo 2^45. The number of draws per ray
; is odd: with a power of two, the low bits of x would be similar for all rays.
; Of N consecutive seeds the nearest two begin at least 2^45 / (2.7 N) draws
; apart, because multiples of the golden ratio are well spaced (three-distance
; theorem).
;
; Scalar operations are grouped by stage, each stage for all draws, so that no
; operation waits for a result. The vector form processes one draw of a queue of
; rays. Its numbers are the same, bit for bit, for any division into queues. A
; vector of states, x one position before each ray's first draw, is made once by
; doubling:
;
;   x_r .. x_r+k-1  times  a^(5 k)  =  x_r+k .. x_r+2k-1
;
; One product advances it to the next queue. A draw does not change the states,
; so the five draws can be taken in any order, for all rays or for some.
;
; Sources: a is the multiplier of RANF on the CYBER 170 and Cray machines, there
; modulo 2^48 (Knuth, TAOCP 2, 3.3.4). The output is mixed by shifts and a
; product as in O'Neill, "PCG" (2014). Skips by binary powers: Brown, "Random
; number generation with arbitrary strides" (1994). c is the upper 48 bits of
; MMIX's multiplier 6364136223846793005 (Knuth). G is derived here.

        .ifndef stream_registers

        .include "frame/common.s"

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

; Registers of the stream, from first on: c, 2^-47, 1, a .. a^5.
        .macro  stream_registers first
        .regs   \first, stream_mix, stream_to_unit, stream_one, stream_ahead0, stream_ahead1, stream_ahead2, stream_ahead3, stream_ahead4
        .endm

        .macro  stream_load scratch
        load_words stream_constants, STREAM_CONSTANTS, stream_mix, \scratch
        MPYL    stream_ahead0, stream_ahead0, stream_ahead1
        MPYL    stream_ahead1, stream_ahead0, stream_ahead2
        MPYL    stream_ahead1, stream_ahead1, stream_ahead3
        MPYL    stream_ahead2, stream_ahead1, stream_ahead4
        .endm

; `power` := a^exponent mod 2^47, for an integer `exponent` in [0, 2^47), which
; becomes 0.
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

; `state` := x of the position s G + number draws: the state of ray `number`
; under the seed s if each ray takes `draws` numbers. `seed`, in [0, 2^45), and
; `number` are registers with integers, `draws` is an integer. `number` and
; `draws` may be negative. `position`, `square` and `bit` are scratch.
        .macro  stream_state seed, number, draws, state, position, square, bit
        EX      \position, STREAM_SEED_APART
        MPYL    \position, \seed, \position
        ES      \square, \draws
        MPYL    \square, \number, \square
        ADDX    \position, \square, \position
        MPYL    \position, stream_one, \position        ; mod 2^47
        stream_power \position, \state, \square, \bit
        .endm

; [word] := t of x, and u := word 2^-47, for `count` registers each: x\+ means
; x0, x1 and so on. work\+ is scratch.
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

; word\+ := the t of the ray's five draws. `state` advances to the next ray.
; work\+ is scratch.
        .macro  stream_words state, word, work
        .rept   STREAM_DRAWS
        MPYL    \state, stream_ahead\+, \word
        .endr
        MPYL    \state, stream_ahead4, \state
        stream_mixed STREAM_DRAWS, \word, \word, \work
        .endm

; Registers of the vector form in addition, from first on: the shifts.
        .macro  stream_vector_registers first
        .regs   \first, stream_first_shift, stream_second_shift
        .endm

        .macro  stream_vector_load
        ES      stream_first_shift, -23
        ES      stream_second_shift, -24
        .endm

; Stores the states of `count` rays at the address `at`. `state` is that of the
; first ray. `at` has no length and is not changed. `state`, `done`, `left`,
; `factor`, `from` and `into` are scratch.
        .macro  stream_seeds at, count, state, done, left, factor, from, into
        STO     [\at], \state
        ES      \done, 1
        RTOR    stream_ahead4, \factor
double\@:
        SUBX    \count, \done, \left
        IBXLE   \left, r0, r0, seeded\@
        SHIFTI  \done, 6, \into
        ADDX    \at, \into, \into
        IBXLE   \left, r0, \done, last\@
        RTOR    \done, \left
last\@:
        ADDLEN  \at, \left, \from
        ADDLEN  \into, \left, \into
        MPYLV   [\from], \factor, [\into]
        MPYL    \factor, \factor, \factor
        ADDX    \done, \done, \done
        BIM     double\@
seeded\@:
        .endm

; `leap` := a^(5 rays). Multiplied by it, [states] advance by the number `rays`.
        .macro  stream_leap rays, leap, exponent, square, bit
        ES      \exponent, STREAM_DRAWS
        MPYL    \exponent, \rays, \exponent
        stream_power \exponent, \leap, \square, \bit
        .endm

; [words] := t of the x in [states]. Both may be the same vector. `work` is
; another vector of this length, in which nothing is stored.
        .macro  stream_mixed_vector states, words, work
        LINKV
        SHIFTV  [\states], stream_first_shift, [\work]
        XORV    [\work], [\states], [\words]
        MPYLV   [\words], stream_mix, [\words]
        LINKV
        SHIFTV  [\words], stream_second_shift, [\work]
        XORV    [\work], [\words], [\words]
        .endm

; [words] := t of one draw, 0 .. 4, of the rays with these states.
        .macro  stream_draw states, draw, words, work
        MPYLV   [\states], stream_ahead\draw, [\words]
        stream_mixed_vector \words, \words, \work
        .endm

; [u] := [word] 2^-47.
        .macro  stream_unit word, u
        LINKV
        ADDNV   [\word], r0, [\u]
        MPYSV   [\u], stream_to_unit, [\u]
        .endm

        .endif
