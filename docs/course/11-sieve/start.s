; start.s - the primes below a limit, by the sieve of Eratosthenes on a string of bits.

        .include "core.s"

        .ifndef limit                   ; the tests define it
        .equ    limit, 100
        .endif

        .data
        .bitvector prime, limit         ; bit i: i is a prime
count:  .space  1                       ; the number of primes

        .bitvector mask, limit
        .code

        .regs   r10, primes, total
        .regs   r20, one, p, square, bound, skip, at
        .equ    CLEAR, 2                ; I4 of BAB: do not branch, make the bit zero
        .equ    SET, 3                  ; do not branch, make it one
        .equ    IF_ZERO, 12             ; branch if it is zero, leave it

        descriptor primes, prime, limit
        ES      one, 1
        EX      bound, limit
        EX      skip, composite

        .kernel sieve
        MRKO    one, one, [primes]      ; all ones
        BAB     [primes, r0], [r0], CLEAR ; 0 and 1 are no primes
        BAB     [primes, one], [r0], CLEAR
        ES      p, 2
        ES      square, 4
        IBXGE   square, r0, bound, done
next:   BAB     [primes, p], [skip], IF_ZERO
; your code here: strike out p p, p p + p, p p + 2 p ..

composite:
        ADDX    p, one, p
        MPYX    p, p, square
        IBXLT   square, r0, bound, next, square

done:   CNTOB   [primes], total
        EX      at, count
        STO     [at], total
        .endkernel
        EXIT
; expect: [count] = 25
; expect-bits: [prime] = 0011 0101 0001 0100 0101 0001 0000 0101
