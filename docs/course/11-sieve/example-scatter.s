; example-scatter.s - the primes below a limit: flags are words, multiples are struck out by
; a scatter.  The method of asm/examples/sieve.s.

        .include "core.s"

        .ifndef limit
        .equ    limit, 100
        .endif

        .data
        .bitvector prime, limit
flags:  .space  limit
places: .space  limit
        .code

        .regs   r10, fs, primes, list, one, p, square, end, length, flag, total

        load_constant flag, 1.0
        descriptor fs, flags, limit
        descriptor primes, prime, limit
        VTOV    flag, [fs]
        STO     [fs], r0                ; 0 and 1 are no primes
        ES      one, 1
        STO     [fs, one], r0
        ES      p, 2
        ES      square, 4
        EX      end, limit
next:   LOD     [fs, p], flag
        CFPEQ   flag, r0, composite
        SUBX    end, square, length     ; (limit - 1 - p p) / p + 1 multiples
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
        IBXLT   square, r0, end, next, square
        CMPNEV  [fs], r0, [primes]
        CNTOB   [primes], total
        EXIT
; expect: total = 25
