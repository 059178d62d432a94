; scatter.s - the primes below a limit: flags are words, and multiples are struck out by a
; scatter, as in asm/examples/sieve.s.

        .include "core.s"

        .ifndef limit                   ; the tests define it
        .equ    limit, 20000
        .endif

        .data
        .bitvector prime, limit
count:  .space  1

flags:  .space  limit
places: .space  limit
        .code

        .regs   r10, primes, total, flag, fs, list
        .regs   r20, one, p, square, bound, length, at

        descriptor primes, prime, limit
        descriptor fs, flags, limit
        load_constant flag, 1.0
        ES      one, 1
        EX      bound, limit

        .kernel sieve
        VTOV    flag, [fs]
        STO     [fs], r0                ; 0 and 1 are no primes
        STO     [fs, one], r0
        ES      p, 2
        ES      square, 4
        IBXGE   square, r0, bound, done
next:   LOD     [fs, p], flag
        CFPEQ   flag, r0, composite
        SUBX    bound, square, length   ; (limit - 1 - p p) / p + 1 multiples
        ADDX    length, p, length
        IS      length, -1
        DIVU    length, p, length
        TRU     length, length
        EX      list, places
        ADDLEN  list, length, list
        INTVLV  square, p, [list]
        VTOVX   [list], r0, [fs]
composite:
        ADDX    p, one, p
        MPYX    p, p, square
        IBXLT   square, r0, bound, next, square
done:   CMPNEV  [fs], r0, [primes]
        CNTOB   [primes], total
        EX      at, count
        STO     [at], total
        .endkernel
        EXIT
; expect: [count] = 2262
