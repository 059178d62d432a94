; stream_vector.s - the random stream (stream_scalar.s), in queues of rays.
;
; The numbers are those of the scalar form, bit for bit, for any division into
; queues. A vector of states, x one position before each ray's first draw, is
; made once by doubling:
;
;   x_r .. x_r+k-1  times  a^(5 k)  =  x_r+k .. x_r+2k-1
;
; One product advances it to the next queue. A draw does not change the states,
; so the five draws can be taken in any order, for all rays or for some.

        .ifndef stream_seeds

        .include "points/stream_scalar.s"

; Registers in addition to those of the scalar form, from first on: the shifts.
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
