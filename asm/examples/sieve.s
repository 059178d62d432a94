; sieve.s - finds the primes below 200 by the sieve of Eratosthenes.
;
; The flag of i is set if no divisor of i has been found. For each prime p up
; to the root of the limit, the vector unit generates the multiples p p, p p +
; p, .. below the limit, and a scatter of zeros clears their flags. The flags
; are words (1.0 or machine zero), because bits cannot be scattered. A
; comparison packs them into bits at the end.

        .include "print.s"

        .ifndef limit                   ; --define limit=1000
        .equ    limit, 200
        .endif

        .data
flags:  .space  limit
prime:  .space  4
places: .space  limit
        .code

        .regs   r10, fs, ps, bits, list, one, p, square, end, step
        .regs   r20, flag, length, shift, primes, text

; Sets all flags to 1.0, and the flags of 0 and 1 to zero.
        load_constant flag, 1.0
        descriptor fs, flags, limit
        .kernel sieve
        VTOV    flag, [fs]
        STO     [fs], r0
        ES      one, 1
        STO     [fs, one], r0

        ES      p, 2
        ES      end, limit
next:   LOD     [fs, p], flag
        CFPEQ   flag, r0, composite

; There are (limit - 1 - p p) / p + 1 multiples from p p on that are below the
; limit.
        MPYX    p, p, square
        SUBX    end, square, step
        ADDX    step, p, step
        IS      step, -1
        DIVU    step, p, length         ; the exponent of the quotient
        TRU     length, length          ; is not 0; TRU makes it 0
        EX      list, places
        ADDLEN  list, length, list
        INTVLV  square, p, [list]
        VTOVX   [list], r0, [fs]
composite:
        IS      p, 1
        MPYX    p, p, square
        IBXLT   square, r0, end, next, square

        descriptor bits, prime, limit
        CMPNEV  [fs], r0, [bits]
        CNTOB   [bits], primes
        .endkernel

        print_integer primes
        newline
        ELEN    bits, 30
        print_bits bits
        newline
        EXIT
; expect: r23 = 46
; expect-print: 46
; expect-print: 001101010001010001010001000001
; expect-bits: [prime + 190] = 0101000101

; The first access to the page of the data takes 1,030 of these clocks:
; expect-clocks: 3190
; expect-model: cyber205-2pipe-prior
; This model has round constants; the constants of fitted models are not round.
