; example-bit.s - the primes below a limit: one bit after another is struck out.

        .include "core.s"

        .ifndef limit
        .equ    limit, 100
        .endif

        .data
        .bitvector prime, limit
        .code

        .regs   r10, primes, one, p, square, multiple, end, skip, total
        .equ    CLEAR, 2
        .equ    IF_ZERO, 12

        descriptor primes, prime, limit
        ES      one, 1
        EX      end, limit
        EX      skip, composite
        MRKO    one, one, [primes]
        BAB     [primes, r0], [r0], CLEAR
        BAB     [primes, one], [r0], CLEAR
        ES      p, 2
        ES      square, 4
next:   BAB     [primes, p], [skip], IF_ZERO
        RTOR    square, multiple
strike: BAB     [primes, multiple], [r0], CLEAR
        IBXLT   multiple, p, end, strike, multiple
composite:
        ADDX    p, one, p
        MPYX    p, p, square
        IBXLT   square, r0, end, next, square
        CNTOB   [primes], total
        EXIT
; expect: total = 25
