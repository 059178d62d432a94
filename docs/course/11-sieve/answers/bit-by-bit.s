; bit-by-bit.s - the primes below a limit: struck out bit by bit.

        .include "core.s"

        .ifndef limit                   ; the tests define it
        .equ    limit, 20000
        .endif

        .data
        .bitvector prime, limit
count:  .space  1
        .code

        .regs   r10, primes, total
        .regs   r20, one, p, square, multiple, bound, skip, at
        .equ    CLEAR, 2
        .equ    IF_ZERO, 12

        descriptor primes, prime, limit
        ES      one, 1
        EX      bound, limit
        EX      skip, composite

        .kernel sieve
        MRKO    one, one, [primes]
        BAB     [primes, r0], [r0], CLEAR
        BAB     [primes, one], [r0], CLEAR
        ES      p, 2
        ES      square, 4
        IBXGE   square, r0, bound, done
next:   BAB     [primes, p], [skip], IF_ZERO
        RTOR    square, multiple
strike: BAB     [primes, multiple], [r0], CLEAR
        IBXLT   multiple, p, bound, strike, multiple
composite:
        ADDX    p, one, p
        MPYX    p, p, square
        IBXLT   square, r0, bound, next, square
done:   CNTOB   [primes], total
        EX      at, count
        STO     [at], total
        .endkernel
        EXIT
; expect: [count] = 2262
