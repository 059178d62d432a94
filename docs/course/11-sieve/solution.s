; solution.s - the primes below a limit, by the sieve of Eratosthenes on a string of bits.
;
; Even numbers are left out: bit k of odds represents 2 k + 1.  There, too, the multiples
; of p are p bits apart, from that of p p on.

        .include "core.s"

        .ifndef limit                   ; the tests define it
        .equ    limit, 100
        .endif
        .equ    half, limit / 2         ; odd numbers below the limit

        .data
        .bitvector prime, limit
count:  .space  1

        .bitvector odds, half
        .bitvector mask, half
        .bitvector alternate, limit     ; 0101..
        .code

        .regs   r10, primes, sieve, odd_places, rest, struck, total
        .regs   r20, one, two, p, k, step, square, first, length, bound, skip, last, at
        .equ    CLEAR, 2                ; alterations of BAB, which does not branch
        .equ    SET, 3
        .equ    IF_ZERO, 12             ; branches on a zero, leaves the bit

        descriptor primes, prime, limit
        descriptor sieve, odds, half
        descriptor odd_places, alternate, limit
        ES      one, 1
        ES      two, 2
        EX      bound, limit
        EX      last, half
        EX      skip, composite

        .kernel sieve
        MRKO    one, one, [sieve]       ; all ones
        BAB     [sieve, r0], [r0], CLEAR ; 1 is no prime
        ES      p, 3
        ES      square, 9
        IBXGE   square, r0, bound, done
next:   SHIFTI  p, -1, k                ; p = 2 k + 1
        BAB     [sieve, k], [skip], IF_ZERO
        SHIFTI  square, -1, first       ; p p = 2 first + 1
        SUBX    last, first, length
        EX      struck, odds
        ADDX    struck, first, struck
        ADDLEN  struck, length, struck
        EX      rest, mask
        ADDLEN  rest, length, rest
        MRKZ    one, p, [rest]          ; 011..1 011..1 ..
        ANDB    [struck], [rest], [struck]
composite:
        ADDX    p, two, p
        MPYX    p, p, square
        IBXLT   square, r0, bound, next, square

; Expand the odd numbers to all numbers, and set 2.
done:   MRKZ    one, two, [odd_places]
        MRGB    [sieve], [r0], [primes] ? [odd_places]
        BAB     [primes, two], [r0], SET
        CNTOB   [primes], total
        EX      at, count
        STO     [at], total
        .endkernel
        EXIT
; expect: [count] = 25
; expect-bits: [prime] = 0011 0101 0001 0100 0101 0001 0000 0101
