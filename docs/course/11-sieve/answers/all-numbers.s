; all-numbers.s - the primes below a limit by patterns of bits, even numbers included.

        .include "core.s"

        .ifndef limit                   ; the tests define it
        .equ    limit, 20000
        .endif

        .data
        .bitvector prime, limit
count:  .space  1

        .bitvector mask, limit
        .code

        .regs   r10, primes, total, struck, pattern
        .regs   r20, one, p, square, bound, skip, length, at
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
        SUBX    bound, square, length
        EX      struck, prime
        ADDX    struck, square, struck
        ADDLEN  struck, length, struck
        EX      pattern, mask
        ADDLEN  pattern, length, pattern
        MRKZ    one, p, [pattern]
        ANDB    [struck], [pattern], [struck]
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
