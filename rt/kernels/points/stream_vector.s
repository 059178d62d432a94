; stream_vector.s - the random stream (stream_scalar.s has the formulas), a queue
; of rays at a time: the same numbers, bit for bit, wherever the queues are cut.
;
; A vector of states, x one position before each ray's first draw, is made once by
; doubling,
;
;   x_r .. x_r+k-1  times  a^(5 k)  =  x_r+k .. x_r+2k-1,
;
; and goes on to the next queue by one product.  A draw leaves it as it is, so the
; five can be taken in any order, of all rays or of those that are left.

        .ifndef stream_seeds

        .include "points/stream_scalar.s"

; Registers beside those of the scalar form, from first on: the shifts.
        .macro  stream_vector_registers first
        .regs   \first, stream_first_shift, stream_second_shift
        .endm

        .macro  stream_vector_load
        ES      stream_first_shift, -23
        ES      stream_second_shift, -24
        .endm

; The words from the address at on := the states of count rays, of which the
; first one's is state.  at is without length and stays; state, done, left, factor,
; from and into are scratch.
        .macro  stream_seeds at, count, state, done, left, factor, from, into
        STO     [\at], \state
        ES      \done, 1
        RTOR    stream_ahead4, \factor
double\@:
        SUBX    \count, \done, \left
        IBXLE   \left, r0, r0, sown\@
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
sown\@:
        .endm

; leap := a^(5 rays), by which states times [states] go on by so many rays.
        .macro  stream_leap rays, leap, exponent, square, bit
        ES      \exponent, STREAM_DRAWS
        MPYL    \exponent, \rays, \exponent
        stream_power \exponent, \leap, \square, \bit
        .endm

; [words] := t of the x in [states], which may be the same vector.  work is another one,
; as long as words, in which nothing is stored.
        .macro  stream_mixed_vector states, words, work
        LINKV
        SHIFTV  [\states], stream_first_shift, [\work]
        XORV    [\work], [\states], [\words]
        MPYLV   [\words], stream_mix, [\words]
        LINKV
        SHIFTV  [\words], stream_second_shift, [\work]
        XORV    [\work], [\words], [\words]
        .endm

; [words] := t of one of the draws, 0 .. 4, of the rays with these states.
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
